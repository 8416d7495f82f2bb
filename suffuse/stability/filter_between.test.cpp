#include "suffuse/stability/filter_between.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::stability {
namespace {

grains::Grading box(double from, double to) {
    return {{from, to}, {0, 1}, ""};
}

TEST(FilterBetween, ASandUnderAGravelIsJudgedByItsD85) {
    // A base of category 4, log-uniform from 0.1 to 1 mm: d85 = 10^-0.15 mm, d15 = 10^-0.85 mm, d95 = 10^-0.05 mm.
    const grains::Grading base = box(1e-4, 1e-3);
    const double d85 = 1e-3 * std::pow(10, -0.15), d15 = 1e-3 * std::pow(10, -0.85), d95 = 1e-3 * std::pow(10, -0.05);
    const auto good = filter_criteria(base, box(2e-3, 2.0001e-3));
    EXPECT_NEAR(good[0].value.value(), 2e-3 / d85, 1e-4);
    EXPECT_NEAR(good[1].value.value(), 2e-3 / (4 * d85), 1e-4); // category 4: the same rule
    EXPECT_NEAR(good[2].value.value(), 2e-3 / d95, 1e-4);
    EXPECT_NEAR(good[3].value.value(), 2e-3 / d15, 2e-3);
    for (const Criterion& criterion : good) {
        EXPECT_STREQ(filter_word(criterion.verdict), "holds") << criterion.name;
    }
    const auto coarse = filter_criteria(base, box(9e-3, 9.001e-3));
    EXPECT_STREQ(filter_word(coarse[0].verdict), "fails");
    EXPECT_STREQ(filter_word(coarse[2].verdict), "fails"); // 9/0.891 > 9: it never seals
    EXPECT_STREQ(filter_word(coarse[3].verdict), "holds");
}

TEST(FilterBetween, TheLargestFilterFollowsTheFinesOfTheBase) {
    const auto with = [](double fines, double d85) {
        BaseSoil base;
        base.fines = fines, base.d85 = d85;
        base.category = fines > 0.85 ? 1 : fines >= 0.40 ? 2 : fines >= 0.15 ? 3 : 4;
        return largest_filter(base).value();
    };
    EXPECT_NEAR(with(0.90, 0.05e-3).d15, 0.45e-3, 1e-12);
    EXPECT_NEAR(with(0.95, 0.01e-3).d15, 0.2e-3, 1e-12); // at least
    EXPECT_NEAR(with(0.60, 0.2e-3).d15, 0.7e-3, 1e-12);
    EXPECT_NEAR(with(0.40, 1e-3).d15, 0.7e-3, 1e-12);
    EXPECT_NEAR(with(0.39999, 1e-3).d15, 0.7e-3, 2e-7); // joined at 40 % ...
    EXPECT_NEAR(with(0.15, 1e-3).d15, 4e-3, 1e-12);
    EXPECT_NEAR(with(0.1499, 1e-3).d15, 4e-3, 1e-12);   // ... and at 15 %
    EXPECT_NEAR(with(0.20, 1e-3).d15, 3.34e-3, 1e-12);  // 0.7 + 20/25 (4 - 0.7) mm
    EXPECT_NEAR(with(0.20, 0.1e-3).d15, 0.7e-3, 1e-12); // no less where 4 d85 is finer
}

TEST(FilterBetween, TheBaseIsRegradedOnTheSieveOf475Millimeters) {
    // Half of the mass is gravel; what passes 4.75 mm is log-uniform from 0.05 mm on.
    const grains::Grading base{{0.05e-3, 4.75e-3, 50e-3}, {0, 0.5, 1}, ""};
    const BaseSoil found = characterize_base(base);
    EXPECT_TRUE(found.is_regraded);
    EXPECT_NEAR(found.d85.value(), 0.05e-3 * std::pow(95, 0.85), 1e-9);
    EXPECT_NEAR(found.fines.value(), std::log(1.5) / std::log(95), 1e-12);
    EXPECT_NEAR(found.d15.value(), 0.05e-3 * std::pow(95, 0.30), 1e-9); // of the whole base
}

TEST(FilterBetween, WhatWasNotMeasuredIsNotGuessed) {
    const grains::Grading open{{0.075e-3, 0.6e-3, 4e-3}, {0.2, 0.6, 1}, ""};
    const auto criteria = filter_criteria(open, box(1e-3, 2e-3));
    EXPECT_TRUE(criteria[0].value);                     // d85 was
    EXPECT_EQ(criteria[3].verdict, Verdict::CannotSay); // d15 was not
    EXPECT_NE(criteria[3].remark.find("not measured"), std::string::npos);
    EXPECT_TRUE(criteria[1].verified); // category 3
    EXPECT_EQ(filter_criteria(box(1e-4, 1e-3), open)[0].verdict, Verdict::CannotSay);
}

} // namespace
} // namespace suffuse::stability
