#include "suffuse/erosion/probe.hpp"

#include "suffuse/erosion/detachment.hpp"

#include <gtest/gtest.h>

namespace suffuse::erosion {
namespace {

/// A coarse grain held by nothing, a fine grain that floats, and a fine grain caught between two coarse ones.
dem::World floating_and_caught() {
    dem::World world;
    world.cell.h = diagonal({4e-3, 4e-3, 4e-3});
    const double density = world.material.density;
    add_grain(world.grains, {1e-3, 1e-3, 1e-3}, 0.2e-3, density);
    add_grain(world.grains, {1e-3, 1e-3, 1.4998e-3}, 0.2e-3, density);
    add_grain(world.grains, {1e-3, 1e-3, 1.2499e-3}, 0.05e-3, density); // overlaps both by 0.1 micrometer
    add_grain(world.grains, {3e-3, 3e-3, 3e-3}, 0.05e-3, density);
    world.grains.fine = {0, 0, 1, 1};
    return world;
}

ProbeSetting setting() {
    ProbeSetting s;
    s.gradient = 0.05;
    s.time_step = 2e-8;
    s.spec.ramp = 200;
    s.spec.watch = 300;
    return s;
}

grains::GrainLoad sideways(double force) {
    return {std::vector<Vec3>(4, Vec3{force, 0, 0})};
}

TEST(Probe, AFloatingGrainMovesAsFreeFlightSays) {
    const ProbeResult result = watch_fines(floating_and_caught(), sideways(3e-9), setting());
    ASSERT_EQ(result.id, (std::vector<std::uint32_t>{2, 3}));
    // The discrete ramp takes its steps at their end: half a step of 200 more than the integral.
    EXPECT_NEAR(result.speed[1].back() / result.free_speed[1], 1, 0.005);
    EXPECT_NEAR(result.displacement[1] / result.free_displacement[1], 1, 0.02);
    EXPECT_EQ(result.twin_speed[1], 0);
}

TEST(Probe, ACaughtGrainStaysAndBothRulesTellItFromTheFloatingOne) {
    ProbeResult result = watch_fines(floating_and_caught(), sideways(3e-9), setting());
    judge_detachment({}, result);
    EXPECT_EQ(result.by_velocity, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(result.by_displacement, (std::vector<std::uint8_t>{0, 1}));
}

TEST(Probe, WithoutFluidTheProbeIsItsTwin) {
    const ProbeResult result = watch_fines(floating_and_caught(), sideways(0), setting());
    for (std::size_t k = 0; k < result.id.size(); ++k) {
        EXPECT_EQ(result.speed[k].back(), result.twin_speed[k]);
        EXPECT_EQ(result.displacement[k], 0);
    }
}

TEST(Probe, LeavesTheEquilibriumAsItWasAndHoldsTheCoarseGrains) {
    const dem::World before = floating_and_caught();
    const auto hash = dem::state_hash(before);
    watch_fines(before, sideways(3e-9), setting());
    EXPECT_EQ(dem::state_hash(before), hash);
}

TEST(Probe, SaysWhenAConstantForceOverstatesTheMotion) {
    ProbeSetting longer = setting();
    longer.fluid.viscosity = 1; // a thousand times thicker than water: the viscous time falls below the watch
    EXPECT_TRUE(watch_fines(floating_and_caught(), sideways(3e-9), longer).beyond_viscous_time);
    EXPECT_FALSE(watch_fines(floating_and_caught(), sideways(3e-9), setting()).beyond_viscous_time);
}

} // namespace
} // namespace suffuse::erosion
