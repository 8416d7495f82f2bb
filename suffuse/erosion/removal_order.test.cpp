#include "suffuse/erosion/removal_order.hpp"

#include "suffuse/dem/step.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>

namespace suffuse::erosion {
namespace {

using Rows = std::vector<std::uint32_t>;

/// Fines between coarse grains: 0 pressed hard between two, 1 pressed lightly between two, 2 resting on one, 3 free;
/// each larger than the next but for 3, the largest.
dem::World four_fines() {
    dem::World world = test::empty_world(0.1);
    const double coarse = 1e-3;
    const auto add_neighbor = [&](const Vec3& at, double r, double overlap, int neighbors) {
        test::add(world, at, r, true);
        for (int side = 0; side < neighbors; ++side) {
            const double away = (coarse + r - overlap) * (side == 0 ? 1 : -1);
            test::add(world, at + Vec3{away, 0, 0}, coarse);
        }
    };
    add_neighbor({0.02, 0.02, 0.02}, 0.30e-3, 3e-6, 2);
    add_neighbor({0.02, 0.05, 0.02}, 0.25e-3, 1e-7, 2);
    add_neighbor({0.02, 0.08, 0.02}, 0.20e-3, 1e-6, 1);
    add_neighbor({0.02, 0.02, 0.08}, 0.35e-3, 0, 0);
    dem::StepCaches caches;
    dem::step(world, caches, test::plan_of(1e-12));
    return world;
}

Rows fines_of(const dem::World& world) {
    Rows rows;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            rows.push_back(g);
        }
    }
    return rows;
}

/// The four by their numbers above.
std::vector<int> order_of(RemovalOrder order) {
    const dem::World world = four_fines();
    const Rows fines = fines_of(world);
    std::vector<int> numbers;
    for (const std::uint32_t g : put_in_order(world, fines, order)) {
        numbers.push_back(static_cast<int>(std::find(fines.begin(), fines.end(), g) - fines.begin()));
    }
    return numbers;
}

TEST(RemovalOrder, IsByDiameterByMeanStressOrByContacts) {
    EXPECT_EQ(order_of(RemovalOrder::Smallest), (std::vector<int>{2, 1, 0, 3}));
    // One contact of 1 um on 0.2 mm carries more than two of 0.1 um on 0.25 mm, and less than two of 3 um.
    EXPECT_EQ(order_of(RemovalOrder::LeastStressed), (std::vector<int>{3, 1, 2, 0}));
    const std::vector<int> by_contacts = order_of(RemovalOrder::FewestContacts);
    EXPECT_EQ(by_contacts[0], 3);
    EXPECT_EQ(by_contacts[1], 2);
}

/// So many loose fines of one size.
dem::World loose_fines(int count) {
    dem::World world = test::empty_world(1);
    for (int g = 0; g < count; ++g) {
        test::add(world, {0.01 * g + 0.005, 0.5, 0.5}, 1e-3, true);
    }
    return world;
}

TEST(RemovalOrder, AmongEqualsFollowsTheSeedAndNotTheStorage) {
    for (const RemovalOrder order :
         {RemovalOrder::Random, RemovalOrder::Smallest, RemovalOrder::LeastStressed, RemovalOrder::FewestContacts}) {
        dem::World world = loose_fines(90), other_seed = world, turned = world;
        other_seed.seed = 2;
        std::reverse(turned.grains.id.begin(), turned.grains.id.end()); // the same grains, stored the other way around
        const auto ids = [&](const dem::World& in) {
            Rows taken;
            for (const std::uint32_t g : put_in_order(in, fines_of(in), order)) {
                taken.push_back(in.grains.id[g]);
            }
            return taken;
        };
        EXPECT_EQ(ids(world), ids(turned));
        EXPECT_NE(ids(world), ids(other_seed));
        Rows sorted = ids(world);
        EXPECT_FALSE(std::is_sorted(sorted.begin(), sorted.end())) << "chance, not the order of the ids";
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(sorted, fines_of(world)) << "each once";
    }
}

TEST(TakeMass, ComesAsNearAsWholeGrainsCan) {
    const dem::World world = loose_fines(10);
    const double m = world.grains.mass[0];
    EXPECT_EQ(take_mass(world, fines_of(world), 0).size(), 0U);
    EXPECT_EQ(take_mass(world, fines_of(world), 0.4 * m).size(), 0U);
    EXPECT_EQ(take_mass(world, fines_of(world), 3.4 * m).size(), 3U);
    EXPECT_EQ(take_mass(world, fines_of(world), 3.6 * m).size(), 4U);
    EXPECT_EQ(take_mass(world, fines_of(world), 10 * m * (1 - 1e-15)).size(), 10U);
    EXPECT_EQ(take_mass(world, fines_of(world), 20 * m).size(), 10U);
}

} // namespace
} // namespace suffuse::erosion
