#include "suffuse/packing/overlaps.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <gtest/gtest.h>

#include "tests/support/clouds.hpp"

namespace suffuse::packing {
namespace {

std::size_t overlaps_in(const dem::World& world) {
    return neighbors::find_pairs(world.cell.h, world.grains.position, world.grains.radius, 0.0).size();
}

TEST(Overlaps, ACloudComesToAPorosityWithoutAny) {
    dem::World world = test::sand_cloud(400);
    world.cell.velocity_gradient = diagonal({1, 1, 1});
    world.grains.velocity.front() = {1, 0, 0};
    EXPECT_TRUE(bring_to_porosity(world, 0.45));
    EXPECT_NEAR(dem::porosity(world), 0.45, 1e-12); // rounding
    EXPECT_EQ(overlaps_in(world), 0U);
    EXPECT_EQ(world.grains.velocity.front(), Vec3{});
    EXPECT_EQ(world.cell.velocity_gradient(0, 0), 0);
}

TEST(Overlaps, BeyondJammingSomeAreLeftAndItSaysSo) {
    dem::World world = test::sand_cloud(400);
    EXPECT_FALSE(bring_to_porosity(world, 0.25, 10)); // spheres jam near 0.36
    EXPECT_GT(overlaps_in(world), 0U);
}

TEST(Overlaps, ACloudComesNearTouchingAndNoFurther) {
    dem::World world = test::sand_cloud(400);
    const double reached = bring_near_touching(world);
    EXPECT_EQ(overlaps_in(world), 0U);
    EXPECT_EQ(reached, dem::porosity(world)); // the reported porosity is that of the world
    EXPECT_GT(reached, 0.34);                 // random spheres of this grading do not pack denser
    EXPECT_LT(reached, 0.46);                 // nor do overlaps resist before grains get into each other's way
}

} // namespace
} // namespace suffuse::packing
