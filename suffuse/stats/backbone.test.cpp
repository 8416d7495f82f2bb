#include "suffuse/stats/backbone.hpp"

#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::stats {
namespace {

/// A ring of four grains, a chain of two that depends on it (4 on 3, 5 on 4), and a grain alone.
dem::World ring_with_tail() {
    dem::World world = test::empty_world(40);
    test::add(world, {10, 10, 10}, 1);
    test::add(world, {11.9, 10, 10}, 1);
    test::add(world, {11.9, 11.9, 10}, 1);
    test::add(world, {10, 11.9, 10}, 1);
    test::add(world, {10, 13.8, 10}, 1);
    test::add(world, {10, 15.7, 10}, 1);
    test::add(world, {30, 30, 30}, 1);
    test::add_contact(world, 0, 1);
    test::add_contact(world, 0, 3);
    test::add_contact(world, 1, 2);
    test::add_contact(world, 2, 3);
    test::add_contact(world, 3, 4);
    test::add_contact(world, 4, 5);
    return world;
}

TEST(Backbone, LosesAChainGrainByGrain) {
    const Backbone backbone = measure_backbone(ring_with_tail(), 2);
    EXPECT_EQ(backbone.rattlers, 3); // 5 has one contact; 4 had two, and has one when 5 is gone
    EXPECT_EQ(backbone.grains, 4);
    EXPECT_EQ(backbone.contacts, 4);
    EXPECT_DOUBLE_EQ(backbone.coordination, 2);
}

TEST(Backbone, IsEmptyWhereNothingCanBeHeld) {
    const Backbone backbone = measure_backbone(ring_with_tail(), 4);
    EXPECT_EQ(backbone.grains, 0);
    EXPECT_EQ(backbone.contacts, 0);
    EXPECT_EQ(backbone.coordination, 0);
}

TEST(Backbone, OfAGrainThatTouchesItsOwnImagesKeepsIt) {
    dem::World world = test::empty_world(1.99);
    test::add(world, {1, 1, 1}, 1);
    test::add_contact(world, 0, 0, {}, {0, 0, 1});
    test::add_contact(world, 0, 0, {}, {0, 1, 0});
    test::add_contact(world, 0, 0, {}, {1, 0, 0});
    const Backbone backbone = measure_backbone(world, 4);
    EXPECT_EQ(backbone.contacts, 3);
    EXPECT_DOUBLE_EQ(backbone.coordination, 6);
}

TEST(Backbone, NeedsFourContactsWithoutFrictionAndTwoWithIt) {
    grains::Material material;
    EXPECT_EQ(least_contacts(material), 2);
    material.friction = 0;
    EXPECT_EQ(least_contacts(material), 4);
}

/// A simple cubic lattice of one grain of radius R and its images, compressed by an overlap of 0.01 R: each contact
/// carries kn 0.01 R, and one contact an axis in a cell of edge 1.99 R gives the pressure kn 0.01 R/(1.99 R)^2.
TEST(Backbone, StiffnessToPressureOfALatticeIsItsClosedForm) {
    dem::World world = test::empty_world(1.99);
    test::add(world, {1, 1, 1}, 1);
    test::add_contact(world, 0, 0, {}, {0, 0, 1});
    test::add_contact(world, 0, 0, {}, {0, 1, 0});
    test::add_contact(world, 0, 0, {}, {1, 0, 0});
    const double stiffness = contact::normal_stiffness(world.material, 1, 1, 0);
    const double pressure = stiffness * 0.01 / (1.99 * 1.99);
    EXPECT_NEAR(stiffness_to_pressure(world), stiffness / (pressure * 2), 1e-9 * stiffness / pressure);
    world.contacts.normal.set(0, {});
    world.contacts.normal.set(1, {});
    world.contacts.normal.set(2, {});
    EXPECT_EQ(stiffness_to_pressure(world), 0);
}

} // namespace
} // namespace suffuse::stats
