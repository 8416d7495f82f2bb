#include "suffuse/base/student.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse {
namespace {

TEST(Student, HasTheProbabilitiesOfItsTable) {
    // Two-sided 90 % and 95 % points of the printed table (Abramowitz and Stegun, table 26.10).
    EXPECT_NEAR(student_within(6.314, 1), 0.9, 1e-4);
    EXPECT_NEAR(student_within(2.920, 2), 0.9, 1e-4);
    EXPECT_NEAR(student_within(2.353, 3), 0.9, 1e-4);
    EXPECT_NEAR(student_within(2.132, 4), 0.9, 1e-4);
    EXPECT_NEAR(student_within(2.015, 5), 0.9, 1e-4);
    EXPECT_NEAR(student_within(2.228, 10), 0.95, 1e-4);
    EXPECT_NEAR(student_within(1.699, 29), 0.9, 1e-4);
    EXPECT_EQ(student_within(0, 7), 0);
}

TEST(Student, TheNextSampleLiesWithinAWiderIntervalThanTheMean) {
    EXPECT_NEAR(student_90(7), 1.895, 1e-3);
    EXPECT_NEAR(next_sample_90(8), 1.895 * std::sqrt(1 + 1.0 / 8), 1e-3);
    EXPECT_NEAR(next_sample_90(2), 6.314 * std::sqrt(1.5), 1e-3);
    EXPECT_TRUE(std::isinf(next_sample_90(1)));
    EXPECT_NEAR(next_sample_90(1000), 1.645, 5e-3);
}

} // namespace
} // namespace suffuse
