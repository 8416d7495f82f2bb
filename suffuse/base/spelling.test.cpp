#include "suffuse/base/spelling.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Spelling, DistanceCountsInsertedDroppedReplacedAndSwappedLetters) {
    EXPECT_EQ(suffuse::edit_distance("grading", "grading"), 0U);
    EXPECT_EQ(suffuse::edit_distance("grading", "grdaing"), 1U);
    EXPECT_EQ(suffuse::edit_distance("grading", "gradng"), 1U);
    EXPECT_EQ(suffuse::edit_distance("grading", "gradinng"), 1U);
    EXPECT_EQ(suffuse::edit_distance("grading", "grafing"), 1U);
    EXPECT_EQ(suffuse::edit_distance("fines_contnet", "fines_content"), 1U);
    EXPECT_EQ(suffuse::edit_distance("", "abc"), 3U);
    EXPECT_EQ(suffuse::edit_distance("KPA", "kPa"), 0U);
}

TEST(Spelling, NearestWordStaysWithinItsLimit) {
    const std::vector<std::string> known{"friction", "modulus", "damping"};
    EXPECT_EQ(suffuse::nearest_word("moduls", known), "modulus");
    EXPECT_EQ(suffuse::nearest_word("firction", known), "friction");
    EXPECT_FALSE(suffuse::nearest_word("viscosity", known));
    EXPECT_FALSE(suffuse::nearest_word("xy", {"ab"}));
}

TEST(Spelling, AWordThatBeginsOneKnownWordIsThatOne) {
    const std::vector<std::string> known{"--set", "--output", "--time-limit", "--threads"};
    EXPECT_EQ(suffuse::nearest_word("--out", known), "--output"); // whose dashes are no letters that "--set" keeps
    EXPECT_EQ(suffuse::nearest_word("--time", known), "--time-limit");
    EXPECT_FALSE(suffuse::nearest_word("--t", known));
    EXPECT_FALSE(suffuse::nearest_word("fine", {"fines_content", "finer_than"}));
}

} // namespace
