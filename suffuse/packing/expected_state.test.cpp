#include "suffuse/packing/expected_state.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::packing {
namespace {

double mixture(const std::vector<SizeClass>& classes, double alone) {
    const std::vector<double> fractions = jamming_fractions(classes, alone);
    return *std::min_element(fractions.begin(), fractions.end());
}

TEST(ExpectedState, GrainsOfOneSizeMixToThemselves) {
    EXPECT_DOUBLE_EQ(mixture({{1, 1}}, 0.6), 0.6);
    // Sizes that differ little: what one gains of the other vanishes with the square root of the difference.
    EXPECT_NEAR(mixture({{1, 0.5}, {1 + 1e-9, 0.5}}, 0.6), 0.6, 1e-4);
}

TEST(ExpectedState, EndlesslySmallFinesGiveFurnasLimits) {
    // Fines in the voids of the coarse grains, or coarse grains in a mass of fines [Furnas 1931]; what sizes a million
    // apart still do to each other is of the order of 1e-3.
    for (const double fines : {0.05, 0.2, 0.5, 0.8}) {
        const std::vector<double> found = jamming_fractions(std::vector<SizeClass>{{1, 1 - fines}, {1e-6, fines}}, 0.6);
        EXPECT_NEAR(found[0] * (1 - fines) / 0.6, 1, 5e-3) << fines;
        EXPECT_NEAR(found[1] * (1 - 0.4 * (1 - fines)) / 0.6, 1, 5e-3) << fines;
    }
}

TEST(ExpectedState, TwoSizesPackAsDenselyAsSimulated) {
    // Frictionless samples of size ratio 3.5, of examples/silty-sand-2016: 0.674, 0.740, 0.715, 0.741 within 0.02,
    // which is what the model is off elsewhere too [deLarrard1999].
    const double alone = equal_grains(0, false).solid_fraction;
    const auto at = [&](double fines) { return mixture({{3.5, 1 - fines}, {1, fines}}, alone); };
    EXPECT_NEAR(at(0.05), 0.670, 0.02);
    EXPECT_NEAR(at(0.25), 0.740, 0.02);
    EXPECT_NEAR(at(0.50), 0.715, 0.02);
    EXPECT_NEAR(at(0.80), 0.674, 0.02);
}

TEST(ExpectedState, LessFrictionPacksDenserWithMoreContacts) {
    double fraction = equal_grains(radians(37), true).solid_fraction, contacts = 0;
    for (const double friction : {60.0, 30.0, 20.0, 10.0, 5.0, 0.0}) {
        const EqualGrains state = equal_grains(radians(friction), false);
        EXPECT_GT(state.solid_fraction, fraction) << friction;
        EXPECT_GT(state.coordination, contacts) << friction;
        fraction = state.solid_fraction, contacts = state.coordination;
    }
}

TEST(ExpectedState, AStateIsFoundAgainByItsDensity) {
    for (const double friction : {0.0, 5.0, 10.0, 25.0}) {
        const EqualGrains state = equal_grains(radians(friction), false);
        const EqualGrains found = equal_grains_at(state.solid_fraction);
        EXPECT_NEAR(found.coordination, state.coordination, 1e-9) << friction;
        EXPECT_NEAR(found.rattlers, state.rattlers, 1e-9) << friction;
    }
    EXPECT_DOUBLE_EQ(equal_grains_at(0.1).coordination, equal_grains(0, true).coordination);
}

TEST(ExpectedState, FinesCarryOnceTheyFillTheRoomLeft) {
    const EqualGrains dense = equal_grains(0, false);
    EXPECT_NEAR(carrying_share(dense, dense.filling), 0.5 * (1 - dense.rattlers), 1e-12);
    EXPECT_LT(carrying_share(dense, 0.6), 0.1);
    EXPECT_NEAR(carrying_share(dense, 2), 1 - dense.rattlers, 1e-6);
    EXPECT_DOUBLE_EQ(carrying_share(dense, 0.1), 0.06 * (1 - dense.rattlers)) << "some touch two, however much room";
}

} // namespace
} // namespace suffuse::packing
