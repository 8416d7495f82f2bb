#include "suffuse/stats/coordination.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::stats {
namespace {

/// Three coarse grains in a row (0-1-2), a fine one on grain 1, another fine one on that, and a fine one alone.
dem::World chain_with_fines() {
    dem::World world = test::empty_world(40);
    test::add(world, {10, 10, 10}, 1);
    test::add(world, {11.9, 10, 10}, 1);
    test::add(world, {13.8, 10, 10}, 1);
    test::add(world, {11.9, 11.4, 10}, 0.5, true);
    test::add(world, {11.9, 12.3, 10}, 0.5, true);
    test::add(world, {30, 30, 30}, 0.5, true);
    test::add_contact(world, 0, 1);
    test::add_contact(world, 1, 2);
    test::add_contact(world, 1, 3);
    test::add_contact(world, 3, 4);
    return world;
}

TEST(Coordination, OfAHandMadeChainIsWhatOneCounts) {
    const Coordination z = measure_coordination(chain_with_fines());
    EXPECT_EQ(z.grains, 6);
    EXPECT_EQ(z.contacts, 4);
    EXPECT_DOUBLE_EQ(z.mean, 8.0 / 6);
    EXPECT_EQ(z.rattlers, 4);
    EXPECT_EQ(z.without_contact, 1);
    EXPECT_DOUBLE_EQ(z.mechanical, (8.0 - 3) / 2); // N1 = 3; grains 1 and 3 are active
    EXPECT_EQ(z.histogram, (std::vector<std::int64_t>{1, 3, 1, 1}));
}

TEST(Coordination, ByFractionCountsEachMixedContactOnceForEachSide) {
    const Coordination z = measure_coordination(chain_with_fines());
    EXPECT_DOUBLE_EQ(z.coarse_coarse, 4.0 / 3);
    EXPECT_DOUBLE_EQ(z.coarse_fine, 1.0 / 3);
    EXPECT_DOUBLE_EQ(z.fine_coarse, 1.0 / 3);
    EXPECT_DOUBLE_EQ(z.fine_fine, 2.0 / 3);
}

TEST(Coordination, NearNeighborsThatDoNotTouchAreNotCounted) {
    dem::World world = chain_with_fines();
    world.contacts.normal.set(3, {});
    EXPECT_EQ(measure_coordination(world).contacts, 3);
}

TEST(Coordination, OfAGrainThatTouchesItsOwnImagesIsSix) {
    dem::World world = test::empty_world(1.99);
    test::add(world, {1, 1, 1}, 1);
    test::add_contact(world, 0, 0, {}, {0, 0, 1});
    test::add_contact(world, 0, 0, {}, {0, 1, 0});
    test::add_contact(world, 0, 0, {}, {1, 0, 0});
    EXPECT_DOUBLE_EQ(measure_coordination(world).mean, 6);
}

TEST(Coordination, OfGrainsWithoutContactsIsZeroAndNotNan) {
    dem::World world = test::empty_world(10);
    test::add(world, {1, 1, 1}, 1);
    const Coordination z = measure_coordination(world);
    EXPECT_EQ(z.mean, 0);
    EXPECT_EQ(z.mechanical, 0);
    EXPECT_EQ(z.fine_coarse, 0);
    EXPECT_EQ(z.rattlers, 1);
}

} // namespace
} // namespace suffuse::stats
