// Pairs of held grains may be left out of the contact table where only moving grains matter.

#include "suffuse/dem/step.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

/// Two held grains that overlap, and a free one that falls between them.
World two_held_and_one_free() {
    World world = test::two_grains(1e-3, 1e-3, 1e-5, {});
    const Vec3 middle = 0.5 * (world.grains.position[0] + world.grains.position[1]);
    test::add(world, middle + Vec3{0, 0, 1.15e-3}, 0.5e-3);
    world.grains.motion[0] = world.grains.motion[1] = grains::Motion::Held;
    world.grains.velocity[2] = {0.01, 0, -0.1};
    return world;
}

TEST(HeldPairs, LeftOutMoveFreeGrainsByTheSameBits) {
    World whole = two_held_and_one_free(), part = whole;
    StepCaches of_whole, of_part;
    of_part.neighborhood.leave_out_held_pairs();
    const StepPlan plan = test::plan_of(1e-7, 0.2);
    advance(whole, of_whole, plan, 5000);
    advance(part, of_part, plan, 5000);
    EXPECT_EQ(whole.grains.position[2], part.grains.position[2]);
    EXPECT_EQ(whole.grains.velocity[2], part.grains.velocity[2]);
    EXPECT_EQ(whole.grains.spin[2], part.grains.spin[2]);
    EXPECT_NE(whole.grains.velocity[2], two_held_and_one_free().grains.velocity[2]) << "it met the others";
    EXPECT_EQ(whole.contacts.size() - part.contacts.size(), 1U) << "the pair of held grains";
}

} // namespace
} // namespace suffuse::dem
