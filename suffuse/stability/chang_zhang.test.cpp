#include "suffuse/stability/chang_zhang.hpp"

#include "suffuse/stability/assess.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/gradings_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::stability {
namespace {

using testing::power_law;
using testing::two_boxes;

/// Well graded, no gap, with a share finer than 0.063 mm.
grains::Grading with_fines(double share) {
    return {{0.02e-3, 0.063e-3, 2e-3}, {0, share, 1}, ""};
}

/// A gap from 0.05 mm on, `ratio` wide.
grains::Grading with_gap(double fines, double ratio) {
    return {{0.01e-3, 0.05e-3, 0.05e-3 * ratio, 0.5e-3 * ratio}, {0, fines, fines, 1}, ""};
}

TEST(ChangZhang, TheLineBetweenFiveAndTwentyPercentMeetsBothEnds) {
    // 1 at P = 5 %, 0 at P = 20 %: the two limits that the authors' abstract gives.
    EXPECT_NEAR(*chang_zhang(with_fines(0.0499), 0.2).limit, 1.0, 1e-12);
    EXPECT_NEAR(*chang_zhang(with_fines(0.0500001), 0.2).limit, 1.0, 1e-5);
    EXPECT_NEAR(*chang_zhang(with_fines(0.125), 0.2).limit, 0.5, 1e-9);
    EXPECT_NEAR(*chang_zhang(with_fines(0.1999999), 0.2).limit, 0.0, 1e-5);
    // The line itself was not read in a source, its ends were.
    EXPECT_TRUE(chang_zhang(with_fines(0.0499), 0.2).verified);
    EXPECT_FALSE(chang_zhang(with_fines(0.125), 0.2).verified);
    EXPECT_TRUE(chang_zhang(with_fines(0.21), 0.2).verified);
    const Criterion silty = chang_zhang(with_fines(0.21), 0.2);
    EXPECT_EQ(silty.verdict, Verdict::Stable);
    EXPECT_FALSE(silty.limit);
}

TEST(ChangZhang, AGapIsJudgedByItsRatio) {
    // R3: nothing finer than 0.063 mm, Gr = 10/3 > 3.
    const Criterion boxes = chang_zhang(two_boxes(0.25), 0.2);
    EXPECT_NEAR(*boxes.value, 10.0 / 3, 1e-12);
    EXPECT_EQ(*boxes.limit, 3.0);
    EXPECT_EQ(boxes.verdict, Verdict::Unstable);
    EXPECT_TRUE(boxes.verified);
    EXPECT_EQ(chang_zhang(with_gap(0.08, 2.9), 0.2).verdict, Verdict::Stable);
    EXPECT_EQ(chang_zhang(with_gap(0.08, 3.1), 0.2).verdict, Verdict::Unstable);
    // 0.3 P starts at 3 for P = 10 %; it was not read in a source.
    EXPECT_NEAR(*chang_zhang(with_gap(0.10, 3), 0.2).limit, 3.0, 1e-9);
    EXPECT_NEAR(*chang_zhang(with_gap(0.30, 3), 0.2).limit, 9.0, 1e-9);
    EXPECT_FALSE(chang_zhang(with_gap(0.30, 3), 0.2).verified);
    EXPECT_EQ(chang_zhang(with_gap(0.36, 30), 0.2).verdict, Verdict::Stable);
}

TEST(ChangZhang, ItsLimitsAreUnstableThemselvesAndAreShownSo) {
    // Sizes are binary fractions: Gr is 3 to the bit.
    const grains::Grading at_limit{{0x1p-15, 0x1p-14, 0x3p-14, 0x1p-9}, {0, 0.08, 0.08, 1}, ""};
    const Criterion gap = chang_zhang(at_limit, 0.2);
    EXPECT_EQ(*gap.value, 3);
    EXPECT_EQ(gap.verdict, Verdict::Unstable);
    EXPECT_EQ(limit_text(gap), "< 3");
    EXPECT_EQ(limit_text(chang_zhang(power_law(0.6), 0.2)), "> 1");
}

TEST(Gap, IsFoundWhereSizesAreMissing) {
    const auto gap = find_gap(two_boxes(0.25));
    ASSERT_TRUE(gap);
    EXPECT_EQ(gap->fine_end, 0.30e-3);
    EXPECT_EQ(gap->coarse_end, 1e-3);
    EXPECT_EQ(gap->finer, 0.25);
    // Over two flat segments, neither exactly level.
    const auto two_segments = find_gap({{1e-4, 2e-4, 4e-4, 8e-4, 2e-3}, {0, 0.2, 0.22, 0.24, 1}, ""});
    ASSERT_TRUE(two_segments);
    EXPECT_NEAR(two_segments->coarse_end / two_segments->fine_end, 4, 1e-12);
}

TEST(Gap, AFlatTailOrANarrowStepIsNone) {
    EXPECT_FALSE(find_gap(power_law(0.3)));
    EXPECT_FALSE(find_gap(power_law(0.5)));
    EXPECT_FALSE(find_gap({{1e-6, 1e-4, 2e-3}, {0, 0.04, 1}, ""}));             // fine tail
    EXPECT_FALSE(find_gap({{1e-4, 2e-3, 1e-1}, {0, 0.96, 1}, ""}));             // coarse tail
    EXPECT_FALSE(find_gap({{1e-4, 2e-4, 2.9e-4, 6e-4}, {0, 0.3, 0.3, 1}, ""})); // less than one sieve
}

} // namespace
} // namespace suffuse::stability
