// Tests that stop at a stress: they come there from below, whatever the sample and the path.

#include "suffuse/triaxial/run_path.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>

namespace suffuse::triaxial {
namespace {

constexpr double pressure = 1e5, damping = 0.2;

/// 500 grains at 100 kPa, as the reference left them or, loose, pulled apart and pressed together with friction.
const dem::World& settled_sample(bool loose) {
    static const auto settle = [](bool apart) {
        dem::World world = test::reference_packing("packing500");
        dem::StepCaches caches;
        dem::StepPlan plan = test::plan_of(4e-8, damping);
        if (apart) {
            plan.loading.velocity_gradient = diagonal({200, 200, 200});
            dem::advance(world, caches, plan, 2000); // by 1.6 %
            plan.loading.velocity_gradient.reset();
        }
        plan.loading = dem::isotropic_stress(pressure);
        dem::settle(world, caches, plan, {}, 200'000);
        return world;
    };
    static const dem::World dense = settle(false), open = settle(true);
    return loose ? open : dense;
}

/// A test, and the most and the last that the sample bore of what is specified [-].
struct Stop {
    PathState state;
    double most = 0, last = 0;
};

Stop compress(dem::World& world, const TriaxialSpec& spec) {
    dem::StepCaches caches;
    Stop stop{begin_path(world, spec, dem::mean_stress_tensor(world))};
    bool over = false;
    while (!over) {
        over = path_burst(world, caches, spec, {}, damping, dem::Mode::Reference, stop.state);
        const Mat3& stress = stop.state.balance.stress;
        const double q = stress(2, 2) - 0.5 * (stress(0, 0) + stress(1, 1));
        stop.last = q / deviator_to_stop_at(spec, dem::mean_stress(stress)).value_or(pressure);
        stop.most = std::max(stop.most, stop.last);
    }
    return stop;
}

TEST(StopAtAStress, SmallAndLargeComesFromBelowInLooseAndDenseSamplesOnEveryPath) {
    for (const bool loose : {false, true}) {
        for (const Path path : {Path::Drained, Path::Undrained, Path::ConstantMean}) {
            for (const double q : {2e3, 2e4, 6e4}) {
                dem::World world = settled_sample(loose);
                TriaxialSpec spec;
                spec.path = path;
                spec.deviator_stress = q;
                const Stop stop = compress(world, spec);
                const double balance = 5e-3 * pressure / q; // the error of stress that a balance allows
                const auto where = [&] { return ::testing::Message() << loose << static_cast<int>(path) << " " << q; };
                EXPECT_GE(stop.state.rows.back().deviator_stress, 0.9975 * q) << where();
                EXPECT_LE(stop.most, 1 + std::max(0.01, balance)) << where();
                EXPECT_GE(stop.last, 0.99 - (path == Path::Undrained ? 0.01 : balance)) << where();
                EXPECT_LT(stop.state.pace, 0.1) << where();
            }
        }
    }
}

TEST(StopAtAStress, ARatioOfStressesIsApproachedFromBelowToo) {
    dem::World world = settled_sample(true);
    TriaxialSpec spec;
    spec.stress_ratio = 0.5;
    const Stop stop = compress(world, spec);
    EXPECT_LE(stop.most, 1.01);
    EXPECT_NEAR(stop.last, 1, 0.01);
}

TEST(StopAtAStress, ATestToAStrainKeepsItsPace) {
    dem::World world = settled_sample(false);
    TriaxialSpec spec;
    spec.strain = 1e-3;
    const PathState state = compress(world, spec).state;
    EXPECT_EQ(state.pace, 1);
    EXPECT_EQ(state.least_pace, PathState{}.least_pace);
}

TEST(StopAtAStress, ASampleThatBearsMoreStopsAtOnceAndReturnsToTheSpecifiedStress) {
    dem::World world = settled_sample(false);
    TriaxialSpec spec;
    spec.deviator_stress = 5e4;
    compress(world, spec);
    spec.deviator_stress = 3e4;
    const Stop stop = compress(world, spec);
    EXPECT_EQ(stop.state.phase, PathState::Phase::Done);
    EXPECT_GT(stop.most, 1.5); // which the row of the stop shows
    EXPECT_GT(stop.state.rows.back().deviator_stress, 4.5e4);
    EXPECT_NEAR(stop.last, 1, 0.05);
}

TEST(StopAtAStress, OneJustBeyondTheStrengthIsNotWaitedForWithoutEnd) {
    TriaxialSpec spec;
    spec.inertial_number = 3e-3;
    spec.strain = 0.02;
    dem::World world = settled_sample(true), again = world;
    const PathState strained = compress(world, spec).state;
    const auto bears_less = [](const PathRow& a, const PathRow& b) { return a.deviator_stress < b.deviator_stress; };
    spec.deviator_stress =
        1.02 * std::max_element(strained.rows.begin(), strained.rows.end(), bears_less)->deviator_stress;
    dem::StepCaches caches;
    PathState state = begin_path(again, spec, dem::mean_stress_tensor(again));
    try {
        while (!path_burst(again, caches, spec, {}, damping, dem::Mode::Reference, state)) {
            // The least pace doubles in seven bursts: from a thousandth to all in 73.
            ASSERT_LT(state.steps, strained.steps + 100 * dem::burst_steps);
        }
        EXPECT_NEAR(state.rows.back().deviator_stress, *spec.deviator_stress, 0.01 * *spec.deviator_stress);
    } catch (const StateError&) {
        EXPECT_LE(state.steps, strained.steps + 100 * dem::burst_steps);
    }
}

} // namespace
} // namespace suffuse::triaxial
