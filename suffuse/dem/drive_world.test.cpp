#include "suffuse/dem/drive_world.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/cell/hold_stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <limits>
#include <string>
#include <vector>

namespace suffuse::dem {
namespace {

constexpr std::int64_t endless = std::numeric_limits<std::int64_t>::max();

/// Grains on a cubic lattice, pressed by 0.1 %, or apart by as much; one of them on its way.
World lattice(double spacing_over_diameter = 0.999) {
    constexpr double r = 1e-4;
    const double spacing = 2 * r * spacing_over_diameter;
    World world = test::empty_world(3 * spacing);
    for (int k = 0; k < 27; ++k) {
        const Vec3 site{static_cast<double>(k % 3), static_cast<double>(k / 3 % 3), static_cast<double>(k / 9)};
        test::add(world, spacing * site, r);
    }
    world.grains.velocity[13] = {1e-4, 2e-4, 3e-4};
    return world;
}

StepPlan plan_with(double time_step) {
    StepPlan plan = test::plan_of(time_step, 0.2);
    plan.loading = constant_volume();
    return plan;
}

Advancing advance_in_bursts(World& world, double time_step, std::int64_t most, std::vector<std::int64_t>& bursts) {
    StepCaches caches;
    Advancing advancing;
    advance_world(
        world, caches, plan_with(time_step), 130, advancing, [=] { return most; },
        [&](std::int64_t steps) { bursts.push_back(steps); }
    );
    return advancing;
}

TEST(DriveWorld, StepsAreTheSameHoweverTheyAreCutIntoBursts) {
    World whole = lattice(), cut = lattice();
    std::vector<std::int64_t> bursts, short_bursts;
    EXPECT_EQ(advance_in_bursts(whole, 1e-8, endless, bursts).done, 130);
    EXPECT_EQ(advance_in_bursts(cut, 1e-8, 7, short_bursts).done, 130);
    EXPECT_EQ(bursts, (std::vector<std::int64_t>{50, 50, 30}));
    EXPECT_EQ(short_bursts.size(), 19U);
    EXPECT_EQ(state_hash(whole), state_hash(cut));
}

TEST(DriveWorld, AStepThatIsNotSpecifiedIsThatOfTheNetwork) {
    World world = lattice();
    std::vector<std::int64_t> bursts;
    const Advancing advancing = advance_in_bursts(world, 0, endless, bursts);
    EXPECT_NEAR(advancing.time_step / stable_time_step(world), 1, 1e-2); // that of some steps ago
    EXPECT_EQ(advancing.known_contacts, 81); // three a grain: none touched before the first step
}

TEST(DriveWorld, SettlingIsBurstsUnderTheDragOfTheSlowestMode) {
    World driven = lattice(), by_hand = lattice();
    StepCaches caches, own_caches;
    BalanceSpec spec;
    spec.patience = 200;
    int bursts = 0;
    Settling settling = begin_settling(driven);
    settle_world(driven, caches, plan_with(1e-8), spec, 1'000'000, settling, [&](bool is_over) {
        ++bursts;
        EXPECT_EQ(is_over, settling.balance.balanced_steps >= spec.patience);
    });
    StepPlan plan = plan_with(1e-8);
    plan.drag = slowest_mode_drag(by_hand.grains.size(), plan.dt);
    BalanceState state;
    while (!settle_burst(by_hand, own_caches, plan, spec, state)) {
    }
    EXPECT_EQ(bursts * burst_steps, state.steps);
    cell::hold_stress(plan.loading, by_hand.servo);
    EXPECT_EQ(state_hash(driven), state_hash(by_hand));
    EXPECT_FALSE(settling.collapsed);
}

TEST(DriveWorld, GrainsThatNothingHoldsTogetherCollapse) {
    World apart = lattice(1.001);
    apart.grains.velocity[13] = {};
    StepCaches caches;
    Settling settling = begin_settling(apart);
    settle_world(apart, caches, plan_with(1e-8), {}, 1'000'000, settling, [](bool) {});
    EXPECT_TRUE(settling.collapsed);
}

TEST(DriveWorld, WhatDoesNotSettleInTimeSaysWhatIsMissingAfterItsLastBurst) {
    World world = lattice();
    StepCaches caches;
    BalanceSpec spec;
    spec.unbalanced_force = 1e-30;
    Settling settling = begin_settling(world);
    EXPECT_THROW(settle_world(world, caches, plan_with(1e-8), spec, 200, settling, [](bool) {}), StateError);
    EXPECT_EQ(settling.balance.steps, 200);
}

/// Why a lattice cannot be advanced by so many steps at a rate.
std::string refusal(double rate, std::int64_t steps, double time_step = 1e-7) {
    World world = lattice();
    StepCaches caches;
    Advancing advancing;
    StepPlan plan = plan_with(time_step);
    for (cell::AxisControl& axis : plan.loading.axis) {
        axis = {cell::Control::StrainRate, rate};
    }
    try {
        advance_world(
            world, caches, plan, steps, advancing, [] { return endless; }, [](std::int64_t) {}
        );
    } catch (const StateError& error) {
        return error.what();
    }
    return "";
}

TEST(DriveWorld, ARateIsRefusedThatStrainsTheCellByMoreThanAHundredthInAStep) {
    EXPECT_EQ(refusal(0.99e5, 1), "");
    EXPECT_NE(refusal(1.01e5, 1).find("take 1e+05 1/s at most"), std::string::npos) << refusal(1.01e5, 1);
    EXPECT_NE(refusal(-1e6, 1000).find("strains the cell by 0.1"), std::string::npos);
}

TEST(DriveWorld, ACellIsNotDrivenToWhereItsGrainsHaveNoRoomOrNoNeighbors) {
    EXPECT_NE(refusal(9e4, 10'000).find("overlaps are no longer meaningful"), std::string::npos);
    EXPECT_NE(refusal(-9e4, 10'000).find("no longer touch"), std::string::npos);
}

} // namespace
} // namespace suffuse::dem
