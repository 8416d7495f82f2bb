#include "suffuse/casefile/sweep_value.hpp"

#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

TEST(SweepValue, IsAQuantityHoweverItIsWrittenAndAWordOrAFlagIsNone) {
    for (const Scalar& value : {Scalar("20 %"), Scalar("2 m / 10 m"), Scalar(0.2)}) {
        EXPECT_EQ(quantity_of(value).value().value, 0.2);
        EXPECT_EQ(quantity_of(value).value().dimension, dimension::none);
    }
    EXPECT_EQ(quantity_of(Scalar(std::int64_t{1000})).value().value, 1000);
    EXPECT_EQ(quantity_of(Scalar("100 kPa")).value().value, 1e5);
    EXPECT_EQ(quantity_of(Scalar("100 kPa")).value().dimension, dimension::pressure);
    EXPECT_FALSE(quantity_of(Scalar("mean")));
    EXPECT_FALSE(quantity_of(Scalar(true)));
}

TEST(SweepValue, IsWrittenAsInTheCase) {
    EXPECT_EQ(written(Scalar("100 kPa")), "100 kPa");
    EXPECT_EQ(written(Scalar(0.05)), "0.05");
    EXPECT_EQ(written(Scalar(true)), "true");
}

TEST(SweepValue, AFlagForAFinesContentIsReported) {
    std::string text = full_case;
    const std::string listed = "fines_content = [\"10 %\", 0.2]";
    ASSERT_NE(text.find(listed), std::string::npos);
    const auto problems = problems_of(text.replace(text.find(listed), listed.size(), "fines_content = [true]"));
    EXPECT_NE(find_problem(problems, "E204").message.find("fines_content"), std::string::npos);
}

} // namespace
