#include "suffuse/report/warnings.hpp"

#include <gtest/gtest.h>

namespace suffuse::report {
namespace {

using Lines = std::vector<std::string>;

TEST(MergedWarnings, AWarningOfThreeStagesIsShownOnceWithItsRange) {
    EXPECT_EQ(
        merged_warnings(
            {"fines/fc=0/loose: at 100 kPa a deviator of 12.7 kPa remains", "fines/fc=5/shear: the overlap is 15.1 %",
             "fines/fc=15/loose: at 100 kPa a deviator of 42.1 kPa remains",
             "fines/fc=100/loose: at 100 kPa a deviator of 9 kPa remains"}
        ),
        (Lines{
            "3 stages, fines/fc=15/loose the most: at 100 kPa a deviator of 9 to 42.1 kPa remains",
            "fines/fc=5/shear: the overlap is 15.1 %"})
    );
}

TEST(MergedWarnings, TwoOfAKindAndLinesWithoutAPlaceStayAsTheyAre) {
    const Lines two = {"a/loose: 5 left", "b/loose: 6 left", "no place: 1", "no place: 2", "no place: 3"};
    EXPECT_EQ(merged_warnings(two), two);
    EXPECT_TRUE(merged_warnings({}).empty());
}

TEST(MergedWarnings, EqualNumbersAndDigitsInsideWordsAreNoRange) {
    EXPECT_EQ(
        merged_warnings({"a: E50 is 1.5e-3 and d50 7", "b: E50 is 1.5e-3 and d50 7", "c: E50 is 1.5e-3 and d50 7"}),
        (Lines{"3 stages, a the first: E50 is 1.5e-3 and d50 7"})
    );
    EXPECT_EQ(
        merged_warnings({"a: to 2e-5, E50", "b: to 1e-3, E50", "c: to 4e-6, E50"}),
        (Lines{"3 stages, b the most: to 4e-6 to 1e-3, E50"})
    );
    EXPECT_EQ(merged_warnings({"a: E50", "b: E60", "c: E70"}).size(), 3U);
}

} // namespace
} // namespace suffuse::report
