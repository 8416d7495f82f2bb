#include "suffuse/erosion/probe.hpp"

#include "suffuse/base/parallel.hpp"
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
    s.time_step = 2e-8;
    s.spec.ramp = 200;
    s.spec.watch = 300;
    return s;
}

ProbeLoad sideways(double force) {
    return {0.05, std::vector<Vec3>(4, Vec3{force, 0, 0})};
}

/// One load, one result.
ProbeResult watch_fines(const dem::World& equilibrium, const ProbeLoad& load, const ProbeSetting& setting) {
    return erosion::watch_fines(equilibrium, {&load, 1}, setting).front();
}

TEST(Probe, AFloatingGrainMovesAsFreeFlightSays) {
    const ProbeResult result = watch_fines(floating_and_caught(), sideways(3e-9), setting());
    ASSERT_EQ(result.id, (std::vector<std::uint32_t>{2, 3}));
    // The discrete ramp takes its steps at their end: half a step of 200 more than the integral.
    EXPECT_NEAR(result.speed[1].back() / result.free_speed[1], 1, 0.005);
    EXPECT_NEAR(result.displacement[1] / result.free_displacement[1], 1, 0.02);
    EXPECT_EQ(result.twin_speed[1], 0);
}

TEST(Probe, ACaughtGrainStaysAndBothRulesDistinguishItFromTheFloatingOne) {
    ProbeResult result = watch_fines(floating_and_caught(), sideways(3e-9), setting());
    judge_detachment({}, result);
    EXPECT_EQ(result.by_velocity, (std::vector<std::uint8_t>{0, 1}));
    EXPECT_EQ(result.by_displacement, (std::vector<std::uint8_t>{0, 1}));
}

TEST(Probe, WithoutFluidTheProbeIsItsTwin) {
    dem::World world = floating_and_caught();
    world.grains.position[2].z += 0.05e-6; // off its balance between the two that hold it
    const ProbeResult result = watch_fines(world, sideways(0), setting());
    EXPECT_GT(result.twin_speed[0], 0);
    for (std::size_t k = 0; k < result.id.size(); ++k) {
        EXPECT_EQ(result.speed[k].back(), result.twin_speed[k]);
        EXPECT_EQ(result.displacement[k], 0);
    }
}

TEST(Probe, HoldsTheCoarseGrainsUnlessSpecifiedOtherwise) {
    ProbeSetting loose = setting();
    loose.spec.hold_coarse = false; // the caught grain pushes both apart, and is free
    ProbeResult result = watch_fines(floating_and_caught(), sideways(3e-9), loose);
    judge_detachment({}, result);
    EXPECT_EQ(result.by_displacement, (std::vector<std::uint8_t>{1, 1}));
}

TEST(Probe, LoadsAndThreadsDoNotKnowOfEachOther) {
    const dem::World world = floating_and_caught();
    const std::vector<ProbeLoad> loads = {sideways(0), sideways(3e-9), sideways(5e-9), sideways(7e-9)};
    for (const int threads : {1, 2, 3}) {
        set_thread_count(threads);
        const std::vector<ProbeResult> together = erosion::watch_fines(world, loads, setting());
        ASSERT_EQ(together.size(), loads.size());
        for (std::size_t l = 0; l < loads.size(); ++l) {
            const ProbeResult alone = watch_fines(world, loads[l], setting());
            EXPECT_EQ(together[l].speed, alone.speed);
            EXPECT_EQ(together[l].twin_speed, alone.twin_speed);
            EXPECT_EQ(together[l].displacement, alone.displacement);
        }
    }
    set_thread_count(1);
}

TEST(Probe, CanBeInterruptedBetweenBursts) {
    struct Enough {};

    long long last = -1;
    const Pulse pulse = [&](std::string_view, long long steps) {
        last = steps;
        if (steps >= 600) { // in the second copy of two: the twin's 500 steps come first on one thread
            throw Enough{};
        }
    };
    const ProbeLoad load = sideways(3e-9);
    EXPECT_THROW(erosion::watch_fines(floating_and_caught(), {&load, 1}, setting(), pulse), Enough);
    EXPECT_EQ(last, 600);
}

TEST(Probe, SaysWhenAConstantForceOverstatesTheMotion) {
    ProbeSetting longer = setting();
    longer.fluid.viscosity = 1; // a thousand times thicker than water: the viscous time falls below the watch
    EXPECT_TRUE(watch_fines(floating_and_caught(), sideways(3e-9), longer).beyond_viscous_time);
    EXPECT_FALSE(watch_fines(floating_and_caught(), sideways(3e-9), setting()).beyond_viscous_time);
}

} // namespace
} // namespace suffuse::erosion
