// Viscous drag of each grain by its own rate.

#include "suffuse/dem/step.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::dem {
namespace {

TEST(Drag, BrakesEachGrainAndItsSpinByItsOwnShareOfTheRate) {
    World world = test::empty_world(20e-3);
    test::add(world, {5e-3, 5e-3, 5e-3}, 1e-3);
    test::add(world, {5e-3, 5e-3, 15e-3}, 1e-3);
    const Vec3 velocity{0.01, 0.02, -0.01}, spin{1, -2, 3};
    world.grains.velocity = {velocity, velocity};
    world.grains.spin = {spin, spin};
    grains::GrainLoad load{.force = {{}, {}}, .drag = {1, 0.25}};
    StepPlan plan = test::plan_of(1e-5);
    plan.drag = 100;
    plan.load = &load;
    StepCaches caches;
    advance(world, caches, plan, 1000);
    for (const std::size_t g : {0U, 1U}) {
        const double left = std::pow(1 - plan.drag * load.drag[g] * plan.dt, 1000); // the scheme is explicit
        EXPECT_LE(norm(world.grains.velocity[g] - left * velocity), 1e-12 * norm(velocity));
        EXPECT_LE(norm(world.grains.spin[g] - left * spin), 1e-12 * norm(spin));
    }
    load.drag.clear();
    World both = world;
    advance(both, caches = {}, plan, 1);
    EXPECT_EQ(both.grains.velocity[1], world.grains.velocity[1] - plan.dt * (plan.drag * world.grains.velocity[1]))
        << "without shares all are braked alike";
}

} // namespace
} // namespace suffuse::dem
