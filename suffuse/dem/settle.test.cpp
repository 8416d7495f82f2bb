#include "suffuse/dem/settle.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <cmath>
#include <limits>
#include <string>

namespace suffuse::dem {
namespace {

/// A cubic lattice pressed to about 100 kPa: at rest by symmetry, so that only what a test specifies is unbalanced.
World pressed_lattice() {
    constexpr double r = 1e-4, spacing = 2 * r * (1 - 5.6e-4);
    World world = test::empty_world(3 * spacing);
    for (int k = 0; k < 27; ++k) {
        const Vec3 site{static_cast<double>(k % 3), static_cast<double>(k / 3 % 3), static_cast<double>(k / 9)};
        test::add(world, spacing * site, r);
    }
    StepCaches caches;
    step(world, caches, test::plan_of(1e-9));
    return world;
}

struct Settling {
    World world = pressed_lattice();
    StepCaches caches;
    StepPlan plan = test::plan_of(1e-9, 0.2);
    BalanceSpec spec;
    BalanceState state;

    Settling() {
        plan.loading = constant_volume();
        spec.patience = 200;
    }

    /// Bursts until balanced, or ten.
    int bursts() {
        for (int k = 1; k <= 10; ++k) {
            if (settle_burst(world, caches, plan, spec, state)) {
                return k;
            }
        }
        return 0;
    }
};

TEST(Settle, AStepThatFailsLeavesNothingInTheCaches) {
    Settling run;
    step(run.world, run.caches, run.plan);
    const World good = run.world;
    run.world.grains.velocity[13].x = std::numeric_limits<double>::infinity();
    EXPECT_THROW(test::advance(run.world, run.caches, run.plan, 3), Error);
    World fresh = good, again = good;
    StepCaches none;
    step(fresh, none, run.plan);
    step(again, run.caches, run.plan); // of the world that failed: empty
    EXPECT_EQ(state_hash(again), state_hash(fresh));
}

TEST(Settle, TakesAsManyBalancedStepsInARowAsSpecified) {
    Settling run;
    EXPECT_EQ(run.bursts(), 4); // 4 x 50 steps
    EXPECT_EQ(run.state.steps, 200);
}

TEST(Settle, NeedsTheForcesBalanced) {
    Settling run;
    run.world.grains.velocity[13] = {1e-3, 0, 0};
    run.spec.unbalanced_force = 1e-12;
    EXPECT_EQ(run.bursts(), 0);
}

TEST(Settle, ToNoStressIsOverWhenNothingIsBorneAndNotBefore) {
    Settling run;
    run.plan.loading = isotropic_stress(0);
    run.plan.loading.servo.max_rate = 0; // held at 100 kPa, and balanced
    EXPECT_EQ(run.bursts(), 0);
    run.plan.loading.servo.max_rate = 1e3;
    run.plan.dt = 1e-8;
    const BalanceState rest = settle(run.world, run.caches, run.plan, run.spec, 20'000);
    EXPECT_LT(std::abs(mean_stress(rest.stress)), 1e-8 * run.world.material.modulus);
    run.world.cell.h = 1.1 * run.world.cell.h;
    for (Vec3& place : run.world.grains.position) {
        place *= 1.1; // nothing touches any more
    }
    StepCaches caches;
    EXPECT_EQ(settle(run.world, caches, run.plan, run.spec, 20'000).equilibrium.contacts, 0);
}

TEST(Settle, NeedsTheStressesMet) {
    Settling run;
    run.plan.loading = isotropic_stress(2e5);
    run.plan.loading.servo.max_rate = 0;
    EXPECT_EQ(run.bursts(), 0);
    EXPECT_GT(stress_error(run.plan.loading, run.state.stress), 0.4);
    run.plan.loading = isotropic_stress(mean_stress(run.state.stress));
    run.plan.loading.servo.max_rate = 0;
    EXPECT_EQ(run.bursts(), 4);
}

TEST(Settle, StartsToCountAnewAfterADisturbance) {
    Settling run;
    for (int k = 0; k < 3; ++k) {
        EXPECT_FALSE(settle_burst(run.world, run.caches, run.plan, run.spec, run.state));
    }
    run.plan.loading = isotropic_stress(2e5);
    run.plan.loading.servo.max_rate = 0;
    settle_burst(run.world, run.caches, run.plan, run.spec, run.state);
    EXPECT_EQ(run.state.balanced_steps, 0);
    run.plan.loading = constant_volume();
    EXPECT_EQ(run.bursts(), 4);
}

TEST(Settle, ForcesOnGrainsFromOutsideAreBalancedByThoseOfTheContacts) {
    Settling run;
    grains::GrainLoad weight;
    weight.force.assign(run.world.grains.size(), {0, 0, -1e-4}); // a fortieth of a contact force
    run.plan.load = &weight;
    for (int k = 0; k < 9; ++k) {
        run.world.grains.motion[static_cast<std::size_t>(k)] = grains::Motion::Held; // the lowest layer
    }
    run.plan.dt = 1e-7;
    run.spec.unbalanced_force = 1e-5;
    const BalanceState rest = settle(run.world, run.caches, run.plan, run.spec, 20'000);
    EXPECT_GT(measure_equilibrium(run.world).unbalanced_force, 1e-3) << "without the load it is none";
    EXPECT_LT(rest.equilibrium.unbalanced_force_all, 1e-5);
    EXPECT_NEAR(run.world.grains.force[0].z, -2e-4, 1e-6) << "that of the two layers above";
}

TEST(Settle, DoesNotCallACloudWithoutContactsBalanced) {
    Settling run;
    run.world = test::empty_world(1);
    test::add(run.world, {0.5, 0.5, 0.5}, 0.01);
    EXPECT_EQ(run.bursts(), 0);
}

TEST(Settle, OfGrainsThatJustTouchIsNoBalanceAndNothingOfItIsUnbalanced) {
    Settling run;
    constexpr double spacing = 0.25; // powers of two: touching to the last bit
    run.world = test::empty_world(2 * spacing);
    for (int k = 0; k < 8; ++k) {
        const Vec3 site{static_cast<double>(k % 2), static_cast<double>(k / 2 % 2), static_cast<double>(k / 4)};
        test::add(run.world, spacing * site, 0.5 * spacing);
    }
    add_first_contacts(run.world);
    EXPECT_EQ(measure_equilibrium(run.world).contacts, 24);
    EXPECT_EQ(measure_equilibrium(run.world).unbalanced_force, 0);
    EXPECT_EQ(measure_equilibrium(run.world).unbalanced_force_all, 0);
    EXPECT_EQ(run.bursts(), 0);
}

TEST(Settle, SaysWhatIsMissingWhenItTakesTooLong) {
    Settling run;
    run.plan.loading = isotropic_stress(2e5);
    run.plan.loading.servo.max_rate = 0;
    try {
        settle(run.world, run.caches, run.plan, run.spec, 500);
        FAIL() << "no error";
    } catch (const StateError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("not balanced after 500 steps"), std::string::npos) << message;
        EXPECT_NE(message.find("stress error 5"), std::string::npos) << message; // about one half
        EXPECT_NE(message.find("raise max_steps"), std::string::npos) << message;
    }
}

TEST(StressError, IsTheLargestOfTheControlledAxesAgainstTheLargestTarget) {
    cell::Loading loading;
    loading.axis[0] = {cell::Control::Stress, 100};
    loading.axis[1] = {cell::Control::Stress, 0};
    EXPECT_DOUBLE_EQ(stress_error(loading, diagonal({99, 5, 777})), 0.05);
    EXPECT_EQ(stress_error(constant_volume(), diagonal({1, 2, 3})), 0);
    loading.velocity_gradient = Mat3{};
    EXPECT_EQ(stress_error(loading, {}), 0);
}

TEST(Step, StopsAtAForceThatIsNotANumber) {
    Settling run;
    run.world.grains.velocity[0].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(test::advance(run.world, run.caches, run.plan, 3), Error);
}

TEST(CarriesNothing, WhereTheVolumeIsHeldAndTheStressIsGone) {
    const BalanceSpec spec;
    BalanceState state;
    state.steps = spec.patience;
    EXPECT_TRUE(carries_nothing(constant_volume(), spec, state, 0)); // a cloud
    EXPECT_TRUE(carries_nothing(constant_volume(), spec, state, 1e5));
    EXPECT_FALSE(carries_nothing(isotropic_stress(1e5), spec, state, 1e5)) << "is pressed together again";
    state.stress = diagonal({1, 1, 1});
    EXPECT_FALSE(carries_nothing(constant_volume(), spec, state, 0.9e6)) << "a millionth of it is gone";
    EXPECT_TRUE(carries_nothing(constant_volume(), spec, state, 1.1e6));
    EXPECT_FALSE(carries_nothing(constant_volume(), spec, state, 0));
    state.stress = {};
    state.steps = spec.patience - 1;
    EXPECT_FALSE(carries_nothing(constant_volume(), spec, state, 1e5));
}

TEST(StressError, CountsShearStressesThatAreReleasedTogether) {
    cell::Loading loading = isotropic_stress(1e5);
    Mat3 stress = diagonal({1.001e5, 1e5, 1e5});
    stress(0, 1) = stress(1, 0) = 3e3;
    stress(1, 2) = stress(2, 1) = -4e3;
    EXPECT_NEAR(stress_error(loading, stress), 1e-3, 1e-12);
    loading.shear_released = true;
    EXPECT_NEAR(stress_error(loading, stress), 5e-2, 1e-12);
}

} // namespace
} // namespace suffuse::dem
