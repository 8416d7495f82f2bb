#include "suffuse/erosion/mobility.hpp"
#include "suffuse/erosion/refined_ramp.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace suffuse::erosion {
namespace {

/// Half of the mass at 0.2, all of it at 0.4.
MobilityResult two_steps() {
    MobilityResult result;
    result.ramp = {{.gradient = 0.2, .mobile_mass_share = 0.5}, {.gradient = 0.4, .mobile_mass_share = 1}};
    result.mass = {1, 1};
    result.mobile_gradient = {0.2, 0.4};
    result.moves_1 = gradient_that_moves(result, 0.01);
    return result;
}

TEST(MobilityResult, IsReadOffItsCurveBetweenSteps) {
    const MobilityResult result = two_steps();
    EXPECT_NEAR(*gradient_that_moves(result, 0.01), 0.2 / 50, 1e-15);
    EXPECT_NEAR(*gradient_that_moves(result, 0.75), 0.3, 1e-15);
    EXPECT_NEAR(*mobile_share_at(result, 0.1), 0.25, 1e-15);
    EXPECT_NEAR(*mobile_share_at(result, 0.2), 0.5, 1e-15);
    EXPECT_NEAR(*mobile_share_at(result, 0.3), 0.75, 1e-15);
    EXPECT_FALSE(mobile_share_at(result, 0.5));
}

TEST(MobilityResult, IsReadOffNoStepThatHeaveEnds) {
    MobilityResult result = two_steps();
    result.heave_gradient = 0.4;
    EXPECT_TRUE(gradient_that_moves(result, 0.5));
    EXPECT_FALSE(gradient_that_moves(result, 0.75)) << "the soil heaves first";
    result.ramp[1].still_moving = 0.02;
    EXPECT_EQ(mobile_share_at(result, 0.2), 0.5);
    for (const double gradient : {0.3, 0.4}) {
        EXPECT_FALSE(mobile_share_at(result, gradient)) << gradient;
        EXPECT_FALSE(is_lower_bound(result, gradient)) << gradient;
    }
    EXPECT_EQ(steps_below_heave(result).size(), 1U);
}

TEST(MobilityResult, IsAnUpperBoundOfItsGradientWhereTheLevelBelowWasLeftEarly) {
    MobilityResult result = two_steps();
    EXPECT_FALSE(is_upper_bound(result, 0.75));
    result.ramp[0].still_moving = 0.02;
    EXPECT_TRUE(is_upper_bound(result, 0.75));
    EXPECT_TRUE(is_upper_bound(result, 0.01)) << "a step of 0.2 within which more would move";
    result.ramp[0].gradient = gradient_width;
    EXPECT_FALSE(is_upper_bound(result, 0.01)) << "known to a hundredth all the same";
}

TEST(MobilityResult, LeavesWhatIsMobileAndFitsThrough) {
    MobilityResult result = two_steps();
    mark_leaving(result, std::vector<std::uint8_t>{0, 1});
    EXPECT_EQ(result.ramp[0].leaving_mass_share, 0.0);
    EXPECT_EQ(result.ramp[1].leaving_mass_share, 0.5);
}

TEST(MobilityResult, GivesAFactorOfSafetyOrWhatItIsAtLeast) {
    MobilityResult result = two_steps();
    EXPECT_FALSE(factor_of_safety(result)); // of which gradient?
    result.specified_gradient = 0.002;
    EXPECT_NEAR(*factor_of_safety(result)->factor, 2, 1e-12);
    EXPECT_FALSE(factor_of_safety(result)->is_at_most);
    result.moves_1.reset(); // not reached by the ramp
    result.ramp[0].mobile_mass_share = result.ramp[1].mobile_mass_share = 0.009;
    result.specified_gradient = 0.1;
    EXPECT_FALSE(factor_of_safety(result)->factor);
    EXPECT_NEAR(factor_of_safety(result)->at_least, 4, 1e-12);
    result.ramp[1].still_moving = 0.02;
    EXPECT_NEAR(factor_of_safety(result)->at_least, 2, 1e-12) << "a longer hold of the last may move 1 %";
}

TEST(MobilityResult, GivesAFactorOfSafetyThatIsABoundWhereItsGradientIs) {
    MobilityResult result = two_steps();
    result.ramp[0].mobile_mass_share = 0.002, result.ramp[0].still_moving = 0.02;
    result.moves_1 = gradient_that_moves(result, 0.01);
    result.specified_gradient = 0.1;
    EXPECT_TRUE(factor_of_safety(result)->is_at_most);
    EXPECT_NEAR(*factor_of_safety(result)->factor, *result.moves_1 / 0.1, 1e-12);
    EXPECT_EQ(factor_of_safety(result)->at_least, 0) << "no step is known to move less";
    result.ramp.insert(result.ramp.begin(), {.gradient = 0.05, .mobile_mass_share = 0.001});
    EXPECT_NEAR(factor_of_safety(result)->at_least, 0.5, 1e-12);
}

} // namespace
} // namespace suffuse::erosion
