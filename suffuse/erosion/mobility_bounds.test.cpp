#include "suffuse/erosion/mobility_bounds.hpp"

#include "suffuse/erosion/mobility_result.hpp"

#include <gtest/gtest.h>

namespace suffuse::erosion {
namespace {

TEST(MobilityBounds, OfTheRestAreAFiftiethOfADiameterAndTwoGrainsOfAThousand) {
    EXPECT_FALSE(moves_in_rest(0.0199, 1));
    EXPECT_TRUE(moves_in_rest(0.0201, 1));
    EXPECT_FALSE(moves_in_rest(0.0201, 2));
    EXPECT_TRUE(are_resting(2, 1000));
    EXPECT_FALSE(are_resting(2, 999));
    EXPECT_TRUE(are_resting(0, 10));
}

TEST(MobilityBounds, AGrainHasFallenBeyondHalfItsDiameterAndIsLiftedBeyondATenth) {
    EXPECT_FALSE(has_fallen(0.99, 2));
    EXPECT_TRUE(has_fallen(1.01, 2));
    EXPECT_FALSE(is_lifted(0.099));
    EXPECT_TRUE(is_lifted(0.101));
}

TEST(MobilityBounds, AGradientIsHeldOnForMotionOfAHundredthOfADiameter) {
    EXPECT_FALSE(goes_on(0.3099, 0.3));
    EXPECT_TRUE(goes_on(0.3101, 0.3));
    EXPECT_FALSE(is_still_growing({.still_moving = 0.0029}));
    EXPECT_TRUE(is_still_growing({.still_moving = 0.0031}));
}

TEST(MobilityBounds, OnceATenthIsMobileTheRampRisesAtOneRateAtLeast) {
    EXPECT_EQ(share_of_hold(0.0999, 0.01), 1);
    EXPECT_DOUBLE_EQ(share_of_hold(0.1, 0.05), 0.1);
    EXPECT_DOUBLE_EQ(share_of_hold(0.1, 0.1), 0.2);
    EXPECT_DOUBLE_EQ(share_of_hold(0.1, 5), 0.2);
}

TEST(MobilityBounds, TheFlowIsOldOnceThreeFinesOfAThousandHaveMovedTheirDiameter) {
    EXPECT_FALSE(is_flow_old(0.0029));
    EXPECT_TRUE(is_flow_old(0.0031));
}

} // namespace
} // namespace suffuse::erosion
