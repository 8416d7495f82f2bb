#include "suffuse/dem/relax.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/equilibrium.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

/// Three grains in a row between two held ones, pressed by `overlap` radii, the middle one out of line by `offset`
/// radii: nothing holds it, and the row gives way sideways, slowly, for little pushes it.
World buckling_row(double overlap, double offset) {
    constexpr double r = 1e-4;
    World world = test::empty_world(30 * r);
    world.material.friction = 0;
    world.material.rolling_stiffness = 0;
    for (int k = 0; k < 5; ++k) {
        test::add(world, {(5 + (2 - overlap) * k) * r, (15 + (k == 2 ? offset : 0)) * r, 15 * r}, r);
    }
    world.grains.motion.front() = world.grains.motion.back() = grains::Motion::Held;
    return world;
}

TEST(Relax, LetsGoOfGrainsThatOnlyCreepUnderItsDrag) {
    constexpr double dt = 4e-8;
    World creeping = buckling_row(1e-4, 2e-3);
    StepPlan plan = test::plan_of(dt, 0.2);
    plan.drag = slowest_mode_drag(creeping.grains.size(), dt);
    StepCaches caches;
    test::advance(creeping, caches, plan, 5000);
    EXPECT_GT(measure_equilibrium(creeping).unbalanced_force, 1e-4); // the drag alone does not get far

    World world = buckling_row(1e-4, 2e-3);
    StepCaches fresh;
    const RelaxReport report = relax(world, fresh, dt, 0.2, 1e-8, 400'000);
    EXPECT_LE(report.unbalanced_force, 1e-8);
    EXPECT_FALSE(report.reached_floor);
}

TEST(Relax, ReportsTheFloorWhereNothingGetsOn) {
    World world = buckling_row(1e-4, 0); // in line to the last bit, but pressed unevenly: wanted is less than rounding
    world.grains.position[1].x += 1e-11;
    StepCaches caches;
    const RelaxReport report = relax(world, caches, 4e-8, 0.2, 1e-30, 400'000);
    EXPECT_TRUE(report.reached_floor);
    EXPECT_LT(report.unbalanced_force, 1e-6);
    EXPECT_LT(report.steps, 400'000);
}

TEST(Relax, OfGrainsThatNothingHoldsIsAnErrorAndNoBalance) {
    World cloud = test::empty_world(10e-3);
    test::add(cloud, {2e-3, 2e-3, 2e-3}, 1e-3);
    test::add(cloud, {7e-3, 7e-3, 7e-3}, 1e-3);
    StepCaches caches;
    EXPECT_THROW(relax(cloud, caches, 4e-8, 0.2, 1e-8, 400'000), StateError);
}

} // namespace
} // namespace suffuse::dem
