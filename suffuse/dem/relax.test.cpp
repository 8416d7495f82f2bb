#include "suffuse/dem/relax.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/settle.hpp"

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
    Relaxation report;
    relax(world, fresh, dt, 0.2, 1e-8, 400'000, report);
    EXPECT_LE(report.unbalanced_force, 1e-8);
    EXPECT_FALSE(report.reached_floor);
}

TEST(Relax, ReportsTheFloorWhereNothingGetsOn) {
    World world = buckling_row(1e-4, 0); // in line to the last bit, but pressed unevenly: wanted is less than rounding
    world.grains.position[1].x += 1e-11;
    StepCaches caches;
    Relaxation report;
    relax(world, caches, 4e-8, 0.2, 1e-30, 400'000, report);
    EXPECT_TRUE(report.reached_floor);
    EXPECT_LT(report.unbalanced_force, 1e-6);
    EXPECT_LT(report.steps, 400'000);
}

TEST(Relax, StoppedAtAnyBeatGoesOnToTheSameBits) {
    World whole = buckling_row(1e-4, 2e-3), parts = whole;
    StepCaches caches;
    Relaxation at_once, so_far;
    relax(whole, caches, 4e-8, 0.2, 1e-8, 400'000, at_once);
    int stops = 0;
    for (bool is_over = false; !is_over;) {
        StepCaches fresh; // as after a checkpoint
        long long first = -1;
        try {
            relax(parts, fresh, 4e-8, 0.2, 1e-8, 400'000, so_far, [&](std::string_view /*part*/, long long steps) {
                first = first < 0 ? steps : first;
                if (steps - first >= 40 * burst_steps) {
                    throw Interrupted("enough");
                }
            });
            is_over = true;
        } catch (const Interrupted&) {
            ++stops;
        }
    }
    EXPECT_GT(stops, 2);
    EXPECT_EQ(so_far.steps, at_once.steps);
    EXPECT_EQ(so_far.unbalanced_force, at_once.unbalanced_force);
    EXPECT_EQ(parts.grains.position, whole.grains.position);
    EXPECT_EQ(parts.grains.velocity, whole.grains.velocity);
}

TEST(Relax, OfGrainsThatNothingHoldsIsAnErrorAndNoBalance) {
    World cloud = test::empty_world(10e-3);
    test::add(cloud, {2e-3, 2e-3, 2e-3}, 1e-3);
    test::add(cloud, {7e-3, 7e-3, 7e-3}, 1e-3);
    StepCaches caches;
    Relaxation report;
    EXPECT_THROW(relax(cloud, caches, 4e-8, 0.2, 1e-8, 400'000, report), StateError);
}

} // namespace
} // namespace suffuse::dem
