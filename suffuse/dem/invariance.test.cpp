// What must not matter: where the sample lies, how its cell is turned or its basis chosen, how grains are numbered,
// whether a list is fresh.

#include "suffuse/contact/carry_over.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace suffuse::dem {
namespace {

constexpr double dt = 4e-8;    // [s]
constexpr int steps = 200;     // rounding grows in a packing: this is before it does
constexpr double close = 1e-9; // relative; rounding of 1e-16 on lengths whose overlaps are 1e-3 of them, and its growth

double largest(const Mat3& m) {
    double most = 0;
    for (const auto& row : m.m) {
        for (const double v : row) {
            most = std::max(most, std::abs(v));
        }
    }
    return most;
}

/// A packing that has taken up its load, with shear forces and moments in its contacts.
const World& loaded_packing() {
    static const World world = [] {
        World packing = test::reference_packing("packing500");
        StepCaches caches;
        test::advance(packing, caches, test::plan_of(dt, 0.2), 100);
        packing.contacts = contact::touching_rows(packing.contacts);
        return packing;
    }();
    return world;
}

/// Shears the packing; no damping, which acts along the axes and so is not the same in a turned frame.
StepPlan shearing(const Mat3& frame = identity()) {
    StepPlan plan = test::plan_of(dt);
    plan.loading.velocity_gradient = frame * Mat3{{{{20, 0, 30}, {0, 10, 0}, {0, 0, -30}}}} * transpose(frame);
    return plan;
}

Mat3 run(World& world, const Mat3& frame = identity()) {
    StepCaches caches;
    test::advance(world, caches, shearing(frame), steps);
    return mean_stress_tensor(world);
}

const Mat3& expected_stress() {
    static const Mat3 stress = [] {
        World world = loaded_packing();
        return run(world);
    }();
    return stress;
}

TEST(Invariance, ATranslatedSampleHasTheSameStress) {
    World world = loaded_packing();
    for (Vec3& x : world.grains.position) {
        x += Vec3{0.31e-3, -1.7e-3, 0.05e-3};
    }
    // The mean motion is about the origin of space, now elsewhere in the sample: all grains drift alike.
    EXPECT_LE(largest(run(world) - expected_stress()), close * largest(expected_stress()));
}

TEST(Invariance, AServoHoldsTheSameStressWhateverTheNumberOfItsFirstStep) {
    std::vector<World> ends;
    for (const std::int64_t first_step : {0, 37, 100}) {
        World world = loaded_packing();
        world.clock.step = first_step;
        world.servo = {}; // knows no stiffness yet
        StepPlan plan = test::plan_of(dt, 0.2);
        plan.loading = isotropic_stress(90e3);
        StepCaches caches;
        test::advance(world, caches, plan, 60);
        ends.push_back(std::move(world));
    }
    for (const World& end : ends) {
        EXPECT_EQ(end.cell.h, ends[0].cell.h);
    }
}

TEST(Invariance, ASampleOfGrainsEightTimesAsLargeIsLoadedAsTheSmallOneIs) {
    constexpr double scale = 8;
    World world = test::reference_packing("packing500"), large = world;
    large.grains.mass.clear();
    large.cell.h = scale * large.cell.h;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        large.grains.position[g] *= scale;
        large.grains.radius[g] *= scale;
        large.grains.mass.push_back(std::pow(scale, 3) * world.grains.mass[g]);
        large.grains.inertia[g] *= std::pow(scale, 5);
    }
    StepPlan plan = test::plan_of(dt, 0.2);
    plan.loading = isotropic_stress(1e6); // as quickly as the servo may
    StepPlan slower = plan;
    slower.dt *= scale;
    StepCaches caches, large_caches;
    test::advance(world, caches, plan, steps);
    test::advance(large, large_caches, slower, steps);
    EXPECT_LT(world.cell.h(0, 0), (1 - 1e-4) * test::reference_packing("packing500").cell.h(0, 0));
    EXPECT_LE(largest(large.cell.h - scale * world.cell.h), close * largest(large.cell.h));
}

TEST(Invariance, AServoForgetsTheStiffnessOfBeforeATimeWithoutStressToHold) {
    World world = loaded_packing();
    StepCaches caches;
    StepPlan plan = test::plan_of(dt, 0.2);
    plan.loading = isotropic_stress(90e3);
    test::advance(world, caches, plan, 10);
    EXPECT_GT(world.servo.modulus.x, 0);
    plan.loading = constant_volume();
    test::advance(world, caches, plan, 1);
    EXPECT_EQ(world.servo.modulus, Vec3{});
}

TEST(Invariance, ARotatedSampleHasTheRotatedStress) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const Mat3 q = Mat3{{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}} * Mat3{{{{1, 0, 0}, {0, c, -s}, {0, s, c}}}};
    World world = loaded_packing();
    world.cell.h = q * world.cell.h;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        for (Vec3* v : {&world.grains.position[g], &world.grains.velocity[g], &world.grains.spin[g]}) {
            *v = q * *v;
        }
    }
    for (std::size_t k = 0; k < world.contacts.size(); ++k) {
        for (contact::VectorColumn* column :
             {&world.contacts.shear_force, &world.contacts.bending, &world.contacts.normal}) {
            column->set(k, q * (*column)[k]);
        }
    }
    const Mat3 stress = run(world, q);
    EXPECT_LE(largest(stress - q * expected_stress() * transpose(q)), close * largest(expected_stress()));
}

TEST(Invariance, AShearedBasisOfTheSameLatticeGivesTheSameTrajectory) {
    World world = loaded_packing(), other = world;
    // b becomes b + a, c becomes c - b - a: the same points of the lattice, other names; images follow.
    const Mat3 change = from_columns({1, 0, 0}, {1, 1, 0}, {-1, -1, 1});
    ASSERT_EQ(determinant(change), 1);
    other.cell.h = other.cell.h * change;
    const Mat3 back = inverse(change);
    for (cell::Image& image : other.contacts.image) {
        const Vec3 k = back * Vec3{double(image.a), double(image.b), double(image.c)};
        image = {
            static_cast<int>(std::lround(k.x)), static_cast<int>(std::lround(k.y)), static_cast<int>(std::lround(k.z))};
    }
    // The contact table is sorted by image too: only pairs that touch twice could change places, and there are none.
    const Mat3 stress = run(world), other_stress = run(other);
    EXPECT_LE(largest(stress - other_stress), close * largest(stress));
    EXPECT_EQ(coordination(world), coordination(other));
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        ASSERT_LE(norm(world.grains.position[g] - other.grains.position[g]), 1e-12 * 1e-3) << g;
    }
}

TEST(Invariance, RenumberedGrainsMoveTheSameToRounding) {
    World world = loaded_packing(), other = world;
    std::vector<std::uint32_t> order(other.grains.size()), new_row(order.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::uint32_t k = 0; k < order.size(); ++k) { // any permutation: 500 and 237 have no common divisor
        order[k] = (237 * k + 91) % 500;
        new_row[order[k]] = k;
    }
    select_rows(other.grains, order);
    other.contacts = contact::renumbered(other.contacts, new_row);
    const Mat3 stress = run(world), other_stress = run(other);
    EXPECT_LE(largest(stress - other_stress), close * largest(stress));
    for (std::uint32_t k = 0; k < order.size(); ++k) {
        ASSERT_LE(norm(world.grains.position[order[k]] - other.grains.position[k]), 1e-12 * 1e-3);
        ASSERT_EQ(world.grains.id[order[k]], other.grains.id[k]);
    }
}

class FreshLists : public testing::TestWithParam<bool> {};

TEST_P(FreshLists, ChangeNoBit) {
    World world = loaded_packing(), other = world;
    StepCaches caches;
    StepPlan plan = shearing();
    if (GetParam()) { // the stress, a sum over the table, comes back through the servo
        plan.loading = isotropic_stress(1.3e5);
        plan.loading.axis[2] = {cell::Control::StrainRate, 30};
    }
    for (int k = 0; k < steps; ++k) {
        step(world, caches, plan);
        StepCaches fresh; // all neighbors searched anew in every step
        step(other, fresh, plan);
    }
    EXPECT_EQ(state_hash(world), state_hash(other));
    EXPECT_GE(caches.neighborhood.prunings(), 2); // and the lists were made again on the way
}

/// The sleep of grains in no contact changes no bit.
void expect_sleep_unseen(bool under_servo, double drag) {
    World world = loaded_packing();
    const std::vector<int> contacts = coordination(world);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        if (contacts[g] == 0) { // fast enough to meet others
            world.grains.velocity[g] = {0.02 * double(g % 5), 0.1 * double(g % 3) - 0.1, 0.03 * double(g % 7) - 0.1};
            world.grains.spin[g] = {double(g % 11), -0.0, 3};
        }
    }
    World other = world;
    StepPlan plan = shearing();
    plan.drag = drag;
    if (under_servo) {
        plan.damping = 0.2;
        plan.loading = isotropic_stress(1.3e5);
    }
    StepPlan awake_plan = plan;
    const grains::GrainLoad nothing;
    awake_plan.load = &nothing; // no force, but grains that a load may push do not sleep
    StepCaches caches, awake;
    std::set<std::uint32_t> sleepers;
    for (int burst = 0; burst < 10; ++burst) {
        advance(world, caches, plan, 150);
        advance(other, awake, awake_plan, 150);
        sleepers.insert(500 - caches.neighborhood.sum_plan().awake_end[0]);
    }
    EXPECT_EQ(state_hash(world), state_hash(other));
    EXPECT_GT(*sleepers.begin(), 20U);
    EXPECT_GE(sleepers.size(), 2U) << "no grain fell asleep or awoke on the way";
}

TEST_P(FreshLists, AndSleepOfGrainsInNoContactChangeNoBit) {
    expect_sleep_unseen(GetParam(), 0);
}

TEST_P(FreshLists, AndSleepUnderDragChangeNoBit) {
    expect_sleep_unseen(GetParam(), 2000); // [1/s], of which a grain in 1500 steps loses a tenth of its motion
}

INSTANTIATE_TEST_SUITE_P(Loadings, FreshLists, testing::Bool(), [](const auto& test) {
    return std::string(test.param ? "UnderServo" : "AtAStrainRate");
});

TEST(Invariance, FrictionlessGrainsMoveTheSameWithOrWithoutComputingTheirRotation) {
    World pushing = test::reference_packing("packing500");
    pushing.material.friction = 0;
    World turning = pushing;
    turning.grains.spin[0] = {1e-200, 0, 0}; // too slow to turn anything, but no shortcut is taken
    ASSERT_TRUE(contacts_only_push(pushing));
    ASSERT_FALSE(contacts_only_push(turning));
    StepCaches pushing_caches, turning_caches;
    StepPlan plan = test::plan_of(dt, 0.2);
    plan.loading = isotropic_stress(100e3);
    advance(pushing, pushing_caches, plan, steps);
    advance(turning, turning_caches, plan, steps);
    EXPECT_EQ(pushing.grains.position, turning.grains.position);
    EXPECT_EQ(pushing.grains.velocity, turning.grains.velocity);
    EXPECT_EQ(pushing.contacts.overlap, turning.contacts.overlap);
    EXPECT_EQ(pushing.cell.h, turning.cell.h);
}

TEST(Invariance, WhatRemembersASlipOrAdheresDoesMoreThanPush) {
    World world = loaded_packing();
    EXPECT_FALSE(contacts_only_push(world)); // friction
    world.material.friction = 0;
    EXPECT_FALSE(contacts_only_push(world)); // shear forces and spins of the time before
    std::ranges::fill(world.grains.spin, Vec3{});
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        world.contacts.shear_force.set(c, {});
        world.contacts.bending.set(c, {});
    }
    EXPECT_TRUE(contacts_only_push(world));
    world.material.adhesion_shear = 1;
    EXPECT_FALSE(contacts_only_push(world));
    world.material.adhesion_shear = 0;
    world.cell.velocity_gradient.m[0][1] = 1;
    EXPECT_FALSE(contacts_only_push(world)); // a sheared cell turns grains
}

/// Fast grains in a shearing cell: the table against a test of every pair with every image.
void expect_no_pair_missed(World world) {
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.velocity[g] =
            0.5 * Vec3{std::sin(1.0 * double(g)), std::cos(2.3 * double(g)), std::sin(3.1 * double(g))};
    }
    StepCaches caches;
    StepPlan plan = test::plan_of(dt);
    plan.loading.velocity_gradient = Mat3{{{{0, 0, 3000}, {0, 500, 0}, {0, 0, -1000}}}};
    for (int k = 0; k < 5; ++k) {
        test::advance(world, caches, plan, 24);
        World now = world; // geometry of the next step's contacts
        StepCaches copy = caches;
        step(now, copy, plan);
        const auto pairs =
            neighbors::find_pairs_exhaustively(now.cell.h, world.grains.position, world.grains.radius, -1e-12);
        std::size_t row = 0;
        for (const neighbors::Pair& pair : pairs) {
            while (row < now.contacts.size() &&
                   neighbors::Pair{now.contacts.first[row], now.contacts.second[row], now.contacts.image[row]} < pair) {
                ++row;
            }
            EXPECT_LT(row, now.contacts.size());
            EXPECT_EQ(
                (neighbors::Pair{now.contacts.first[row], now.contacts.second[row], now.contacts.image[row]}), pair
            );
            EXPECT_TRUE(now.contacts.touches(row));
        }
    }
}

/// The same packing, its grains moved apart by thousands of periods.
World drifted_packing() {
    World world = loaded_packing();
    const auto drift = [](std::uint32_t g) { return cell::Image{4000, 700 * (int(g) % 3) - 700, -2000}; };
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        world.grains.position[g] += cell::shift(world.cell.h, drift(g));
    }
    for (std::size_t c = 0; c < world.contacts.size(); ++c) {
        world.contacts.image[c] =
            world.contacts.image[c] + drift(world.contacts.first[c]) - drift(world.contacts.second[c]);
    }
    return world;
}

TEST(Invariance, NoTouchingPairIsEverMissed) {
    expect_no_pair_missed(loaded_packing());
}

TEST(Invariance, NorOneOfGrainsThatHaveDriftedOverThousandsOfPeriods) {
    expect_no_pair_missed(drifted_packing());
}

} // namespace
} // namespace suffuse::dem
