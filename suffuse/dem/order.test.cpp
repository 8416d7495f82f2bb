#include "suffuse/dem/order.hpp"

#include "suffuse/contact/carry_over.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace suffuse::dem {
namespace {

World stirred_packing() {
    World world = test::reference_packing("packing500");
    StepCaches caches;
    StepPlan plan = test::plan_of(4e-8, 0.2);
    plan.loading.velocity_gradient = diagonal({0, 0, -50});
    test::advance(world, caches, plan, 200);
    return world;
}

TEST(Order, SortingAlongTheCurveChangesNeitherHashNorStressNorIds) {
    World world = stirred_packing();
    const std::uint64_t hash = state_hash(world);
    const double pressure = mean_stress(mean_stress_tensor(world));
    sort_along_curve(world);
    EXPECT_FALSE(std::is_sorted(world.grains.id.begin(), world.grains.id.end())); // it did something
    EXPECT_EQ(state_hash(world), hash);
    EXPECT_NEAR(mean_stress(mean_stress_tensor(world)), pressure, 1e-12 * pressure); // another order of the sum
}

TEST(Order, SortingByIdUndoesSortingAlongTheCurve) {
    World world = stirred_packing();
    const World start = world;
    sort_along_curve(world);
    sort_by_id(world);
    EXPECT_EQ(world.grains.id, start.grains.id);
    EXPECT_EQ(world.grains.position, start.grains.position);
    const contact::Contacts expected = contact::touching_rows(start.contacts);
    EXPECT_EQ(world.contacts.first, expected.first);
    EXPECT_EQ(world.contacts.image, expected.image);
    EXPECT_EQ(world.contacts.shear_force.x, expected.shear_force.x);
    EXPECT_EQ(world.contacts.bending.z, expected.bending.z);
}

TEST(Order, NeighborsInSpaceBecomeNeighborsInMemory) {
    World world = stirred_packing();
    const auto mean_distance = [&] {
        double sum = 0;
        for (const ContactView& c : inspect_contacts(world)) {
            sum += std::abs(static_cast<double>(c.i) - static_cast<double>(c.j));
        }
        return sum;
    };
    sort_by_id(world);
    const double before = mean_distance();
    sort_along_curve(world);
    EXPECT_LT(mean_distance(), 0.7 * before);
}

TEST(Removal, OverManyCyclesLeavesNoStaleContactAndTheHashOfAFreshWorld) {
    World world = stirred_packing();
    StepCaches caches;
    const StepPlan plan = test::plan_of(4e-8, 0.2);
    for (int cycle = 0; cycle < 10; ++cycle) { // 500 grains, 15 a cycle: 30 %
        std::vector<std::uint32_t> rows, ids;
        for (std::uint32_t k = 0; k < 15; ++k) {
            rows.push_back(
                static_cast<std::uint32_t>((37 * k + 11 * static_cast<std::uint32_t>(cycle)) % world.grains.size())
            );
            ids.push_back(world.grains.id[rows.back()]);
        }
        remove_grains(world, rows);
        caches.neighborhood.invalidate();
        ASSERT_EQ(world.grains.size(), 500U - 15U * static_cast<std::size_t>(cycle + 1));
        for (const std::uint32_t id : ids) {
            ASSERT_EQ(std::count(world.grains.id.begin(), world.grains.id.end(), id), 0);
        }
        ASSERT_EQ(world.grains.fine.size(), world.grains.size()); // every column was cut
        ASSERT_EQ(world.grains.torque.size(), world.grains.size());
        for (std::size_t c = 0; c < world.contacts.size(); ++c) {
            ASSERT_LT(world.contacts.second[c], world.grains.size());
            // The memory belongs to the pair: its normal points along the branch, within a step's motion.
            const auto i = world.contacts.first[c], j = world.contacts.second[c];
            const Vec3 branch = world.grains.position[j] + cell::shift(world.cell.h, world.contacts.image[c]) -
                                world.grains.position[i];
            ASSERT_GT(dot(branch, world.contacts.normal[c]), 0.999999 * norm(branch));
        }
        World fresh = world; // as loaded from a file: what touches, and no cache
        fresh.contacts = contact::touching_rows(fresh.contacts);
        test::advance(world, caches, plan, 50);
        StepCaches no_caches;
        test::advance(fresh, no_caches, plan, 50);
        ASSERT_EQ(state_hash(world), state_hash(fresh)) << "cycle " << cycle;
    }
}

TEST(Removal, OfNoGrainOrOfAllIsFine) {
    World world = stirred_packing();
    const std::uint64_t hash = state_hash(world);
    remove_grains(world, {});
    EXPECT_EQ(state_hash(world), hash);
    std::vector<std::uint32_t> all(world.grains.size());
    for (std::uint32_t g = 0; g < all.size(); ++g) {
        all[g] = g;
    }
    remove_grains(world, all);
    EXPECT_EQ(world.grains.size(), 0U);
    EXPECT_EQ(world.contacts.size(), 0U);
    StepCaches caches;
    test::advance(world, caches, test::plan_of(4e-8), 3); // an empty cell can be stepped
}

TEST(Order, ARelocatedGrainIsAtRestElsewhereAndNobodyElseLosesAContact) {
    World world = stirred_packing();
    const World before = world;
    const std::uint32_t moved = world.contacts.first[world.contacts.size() / 2];
    const Vec3 to{1e-3, 2e-3, 3e-3};
    relocate_grains(world, {&moved, 1}, {&to, 1});
    EXPECT_EQ(world.grains.position[moved], to);
    EXPECT_EQ(world.grains.velocity[moved], Vec3{});
    EXPECT_EQ(world.grains.id, before.grains.id);
    std::size_t kept = 0;
    for (const ContactView& c : inspect_contacts(before)) {
        kept += c.i != moved && c.j != moved ? 1 : 0;
    }
    const std::vector<int> contacts = coordination(world);
    EXPECT_EQ(contacts[moved], 0);
    EXPECT_EQ(inspect_contacts(world).size(), kept);
    EXPECT_LT(kept, inspect_contacts(before).size());
}

TEST(StateHash, SeesEveryBitThatTheNextStepDependsOn) {
    World start = stirred_packing();
    start.contacts.twisting.resize(start.contacts.size());
    start.contacts.bonded.resize(start.contacts.size());
    const std::uint64_t hash = state_hash(start);
    std::size_t touching = 0;
    while (!start.contacts.touches(touching)) {
        ++touching;
    }
    const auto nudge = [](double& v) { v = std::nextafter(v, 1e9); };
    const std::vector<std::function<void(World&)>> changes{
        [&](World& w) { nudge(w.cell.h(0, 0)); },
        [&](World& w) { nudge(w.cell.velocity_gradient(1, 2)); },
        [&](World& w) { nudge(w.grains.position[7].x); },
        [&](World& w) { nudge(w.grains.velocity[7].y); },
        [&](World& w) { nudge(w.grains.spin[7].z); },
        [&](World& w) { nudge(w.grains.radius[7]); },
        [&](World& w) { nudge(w.contacts.shear_force.x[touching]); },
        [&](World& w) { nudge(w.contacts.bending.y[touching]); },
        [&](World& w) { nudge(w.contacts.normal.z[touching]); },
        [&](World& w) { nudge(w.contacts.twisting.x[touching]); },
        [&](World& w) { w.contacts.bonded[touching] = 1; },
        [&](World& w) { w.grains.motion[7] = grains::Motion::Held; },
        [&](World& w) { nudge(w.servo.modulus.y); },
        [&](World& w) { nudge(w.servo.shear_modulus.x); },
        [&](World& w) { nudge(w.servo.shear_stress.z); },
        [&](World& w) { ++w.clock.step; },
    };
    for (std::size_t k = 0; k < changes.size(); ++k) {
        World world = start;
        changes[k](world);
        EXPECT_NE(state_hash(world), hash) << "change " << k;
    }
}

} // namespace
} // namespace suffuse::dem
