// Fines in true time: closed forms of one grain and of lattices, and what is conserved.

#include "suffuse/erosion/migration.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/erosion/grain_water.hpp"

#include <gtest/gtest.h>

#include "tests/support/migrations.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace suffuse::erosion {
namespace {

using test::migrate;

constexpr double coarse_diameter = 1e-3; // [m]

/// A fine grain in a wide cell, and a coarse one far from it.
dem::World one_in_wide_water(double diameter) {
    constexpr double wide = 4e-3;
    dem::World world;
    world.cell.h = diagonal({wide, wide, wide});
    add_grain(world.grains, {0.1 * wide, 0.1 * wide, 0.5 * wide}, 0.3e-3, world.material.density);
    add_grain(world.grains, {0.6 * wide, 0.6 * wide, 0.5 * wide}, diameter / 2, world.material.density);
    world.grains.fine = {0, 1};
    return world;
}

TEST(Migration, OfOneGrainInStillWaterIsItsSinkingAtTheVelocityOfStokes) {
    for (const double diameter : {0.1e-3, 0.05e-3}) {
        const MigrateSpec spec{.gradients = {1e-9}, .hold_at_most = 0.1, .gravity = Gravity{}};
        const flow::Fluid water;
        Migration migration = begin_migration(one_in_wide_water(diameter), spec, {water, {}});
        migrate_on(migration, spec, {water, {}}); // it reaches its velocity within a millisecond
        const Vec3 from = migration.ledger.end.front();
        const double since = migration.time;
        while (!migration.over) {
            migrate_on(migration, spec, {water, {}});
        }
        const double velocity = (from.z - migration.ledger.end.front().z) / (migration.time - since);
        const double excess = dem::World{}.material.density - water.density;
        const double stokes = excess * gravity * diameter * diameter / (18 * water.viscosity);
        EXPECT_NEAR(velocity / stokes, 1, 0.01); // walls and other periods are 20 and 40 diameters away
        EXPECT_FALSE(migration.result.holds.front().ended) << "it never rests";
        EXPECT_EQ(migration.ledger.where.front(), Whereabouts::Moving);
    }
}

void add(dem::World& world, const Vec3& place, double diameter, bool is_fine) {
    add_grain(world.grains, place, diameter / 2, world.material.density);
    world.grains.fine.back() = is_fine ? 1 : 0;
}

/// A cubic lattice of coarse grains that just touch, and a fine one in each of its voids.
dem::World cubic_lattice(double size_ratio) {
    constexpr int edge = 2;
    const double D = coarse_diameter;
    dem::World world;
    world.cell.h = diagonal({edge * D, edge * D, edge * D});
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 place{k % edge + 0.5, k / edge % edge + 0.5, k / edge / edge + 0.5};
        add(world, D * place, D, false);
        add(world, D * (place + Vec3{0.5, 0.5, 0.5}), D / size_ratio, true);
    }
    return world;
}

TEST(Migration, OfGrainsTooSmallToSinkIsThatOfTheWaterBetweenThem) {
    // All voids of the lattice see the same flow, whose velocity is Darcy's over the porosity.
    const MigrateSpec spec{.gradients = {0.2}, .exit = 1.9e-3, .hold_at_most = 0.03, .gravity = Gravity{}};
    const flow::Fluid water;
    const Migration migration = migrate(cubic_lattice(100), spec);
    const double porosity = 1 - pi / 6;
    const double velocity = migration.result.rows.back().permeability * water.density * gravity *
                            spec.gradients.front() / water.viscosity / porosity;
    for (std::size_t k = 0; k < migration.ledger.size(); ++k) {
        const double way = migration.ledger.end[k].z - migration.ledger.start[k].z;
        const double time = migration.ledger.left[k] >= 0 ? migration.ledger.left[k] : migration.time;
        EXPECT_NEAR(way / (velocity * time), 1, 0.05) << k; // they begin at rest, and end at the end of a leg
    }
    EXPECT_GT(eroded_mass(migration.ledger), 0);
}

/// The densest lattice of coarse grains that just touch; fine grains above each other in its octahedral voids.
dem::World dense_lattice(double size_ratio) {
    constexpr int edge = 2;
    const double D = coarse_diameter, cube = std::sqrt(2.0) * D;
    dem::World world;
    world.cell.h = diagonal({edge * cube, edge * cube, edge * cube});
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 corner{
            static_cast<double>(k % edge), static_cast<double>(k / edge % edge), static_cast<double>(k / edge / edge)};
        for (const Vec3& place : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}}) {
            add(world, cube * (corner + place + Vec3{0.25, 0.25, 0.25}), D, false);
            add(world, cube * (corner + place + Vec3{0.25, 0.25, 0.75}), D / size_ratio, true);
        }
    }
    world.material.friction = 0;
    world.material.rolling_stiffness = 0;
    return world;
}

TEST(Migration, ThroughTouchingGrainsWithoutFrictionIsThatOfAllFinesBelowTheirSmallestHoleAndOfNoneAbove) {
    // Three grains that touch leave a hole of 2/sqrt(3) - 1 of their diameter: a size ratio of 6.464.
    // Straight up, a grain would balance below another.
    const MigrateSpec spec{.gradients = {4}, .direction = {0.2, 0.1, 1}, .hold_at_most = 1.5, .gravity = Gravity{}};
    const Migration small = migrate(dense_lattice(8), spec), large = migrate(dense_lattice(6), spec);
    EXPECT_EQ(small.result.holds.back().ended_by, HoldEnd::AllLeft);
    EXPECT_NEAR(eroded_mass(small.ledger), small.result.fines_mass, 1e-13 * small.result.fines_mass);
    EXPECT_EQ(eroded_mass(large.ledger), 0);
    EXPECT_TRUE(large.result.holds.front().ended);
}

TEST(Migration, HasAFrictionOfItsOwnAndGivesTheSampleItsFrictionBack) {
    dem::World rough = dense_lattice(6);
    rough.material.friction = 0.6;
    MigrateSpec spec{.gradients = {4}, .direction = {0.2, 0.1, 1}, .hold_at_most = 0.2, .gravity = Gravity{}};
    const Migration smooth = migrate(dense_lattice(6), spec), with_friction = migrate(rough, spec);
    spec.friction = 0;
    const Migration without = migrate(rough, spec);
    EXPECT_EQ(without.ledger.end, smooth.ledger.end);
    EXPECT_NE(without.ledger.end, with_friction.ledger.end);
    EXPECT_EQ(migrated_sample(without, {}).material.friction, 0.6);
}

MigrateSpec through_cubic_lattice() {
    return {.gradients = {0.1, 0.3}, .exit = 1.5e-3, .hold_at_most = 0.4, .gravity = Gravity{}};
}

TEST(Migration, KeepsTheMassOfAllGrains) {
    const dem::World sample = cubic_lattice(5);
    const Migration migration = migrate(sample, through_cubic_lattice());
    const double eroded = eroded_mass(migration.ledger), before = total_mass(sample.grains);
    EXPECT_GT(eroded, 0);
    const dem::World after = migrated_sample(migration, {});
    EXPECT_NEAR((total_mass(after.grains) + eroded) / before, 1, 1e-14);
    EXPECT_EQ(migration.result.rows.back().eroded_mass, eroded);
    EXPECT_EQ(migration.solids_mass, before);
    for (std::size_t g = 0; g < after.grains.size(); ++g) {
        EXPECT_EQ(after.grains.motion[g], grains::Motion::Free);
        EXPECT_EQ(after.grains.velocity[g], Vec3{});
    }
}

TEST(Migration, LetsNoMoreWaterThroughThanTheCoarseGrainsAlone) {
    // The network alone gives 1.12 times that while all fines stand, each in the middle of a void.
    const Migration migration = migrate(cubic_lattice(5), through_cubic_lattice());
    double most = 0;
    for (const MigrationRow& row : migration.result.rows) {
        most = std::max(most, row.permeability);
    }
    EXPECT_LE(most / migration.coarse_permeability, 1 + 1e-12);
    EXPECT_GT(most / migration.coarse_permeability, 0.98) << "the first fines that move take their weight from it";
}

TEST(Migration, TakesFromTheFlowTheWeightOfTheGrainsItCarries) {
    // Carried at a steady speed they do not press the skeleton: of the push on the cell the flow has their weight less.
    const dem::World sample = cubic_lattice(8);
    const flow::Fluid water;
    const double i = 0.5, d = coarse_diameter / 8;
    const double weight = 8 * (sample.material.density - water.density) * sphere_volume(d / 2) * gravity;
    const double push = water.density * gravity * i * cell::volume(sample.cell);
    for (const double with_water : {0.4, 0.8}) {
        const MigrateSpec spec{
            .gradients = {i}, .exit = 1.99e-3, .hold_at_most = 0.02, .with_water = with_water, .gravity = Gravity{}};
        const Migration migration = migrate(sample, spec);
        const MigrationRow& last = migration.result.rows.back();
        const double there = 1 - last.eroded_mass / migration.result.fines_mass; // the others have left
        EXPECT_GT(there, 0);
        EXPECT_NEAR((1 - last.permeability / migration.coarse_permeability) / (there * weight / push), 1, 1e-3);
    }
}

TEST(Migration, SpendsTheEnergyOfItsRows) {
    const dem::World sample = cubic_lattice(5);
    const flow::Fluid water;
    const Migration migration = migrate(sample, through_cubic_lattice(), {water, {}});
    double energy = 0, before = 0;
    for (const MigrationRow& row : migration.result.rows) {
        const double specific = water.density * gravity * row.gradient;
        const double discharge = row.permeability * specific / water.viscosity * 4e-6; // through 2 mm x 2 mm
        energy += specific * discharge * 2e-3 * (row.time - before);
        before = row.time;
        EXPECT_NEAR(row.energy / energy, 1, 1e-9);
        EXPECT_NEAR(row.base_gradient / row.gradient, 1, 1e-12) << "one soil has one gradient";
        EXPECT_NEAR(row.filter_gradient / row.gradient, 1, 1e-12);
    }
}

TEST(Migration, LiftsNothingWithoutFlow) {
    const Migration migration =
        migrate(cubic_lattice(5), {.gradients = {1e-6}, .hold_at_most = 0.3, .gravity = Gravity{}});
    for (std::size_t k = 0; k < migration.ledger.size(); ++k) {
        EXPECT_LE(migration.ledger.end[k].z, migration.ledger.start[k].z + 1e-3 * migration.ledger.diameter[k]);
    }
    EXPECT_EQ(eroded_mass(migration.ledger), 0);
}

TEST(Migration, HasTheSameBitsForAnyNumberOfThreadsAndFromAnyOfItsStates) {
    const dem::World sample = cubic_lattice(5);
    const MigrateSpec spec = through_cubic_lattice();
    const int threads = thread_count();
    set_thread_count(1);
    const Migration one = migrate(sample, spec);
    set_thread_count(3);
    Migration three = begin_migration(sample, spec, {});
    while (!three.over) {
        Migration stopped = three;
        int beats = 0;
        const Pulse stop = [&](std::string_view, long long) {
            if (++beats > 1) {
                throw Interrupted("enough");
            }
        };
        try {
            migrate_on(stopped, spec, {.pulse = stop});
        } catch (const Interrupted&) {
            EXPECT_EQ(stopped.time, three.time) << "as it was before the call";
        }
        migrate_on(three, spec, {});
    }
    set_thread_count(threads);
    EXPECT_EQ(one.ledger.end, three.ledger.end);
    EXPECT_EQ(one.ledger.left, three.ledger.left);
    EXPECT_EQ(one.ledger.passed, three.ledger.passed);
    EXPECT_EQ(one.energy, three.energy);
    EXPECT_EQ(dem::state_hash(one.world), dem::state_hash(three.world));
}

TEST(Migration, EndsWithItsBudgetAndSaysSo) {
    MigrateSpec spec = through_cubic_lattice();
    spec.time_at_most = 0.05;
    const Migration in_time = migrate(cubic_lattice(5), spec);
    EXPECT_NEAR(in_time.time, 0.05, 0.001);
    ASSERT_EQ(in_time.result.holds.size(), 1U);
    EXPECT_FALSE(in_time.result.holds.front().ended);
    EXPECT_EQ(in_time.result.holds.front().ended_by, HoldEnd::TimeLimit);
    EXPECT_EQ(in_time.cut_by, HoldEnd::TimeLimit);
    spec.gradients.resize(1);
    EXPECT_EQ(migrate(cubic_lattice(5), spec).cut_by, HoldEnd::None) << "no gradient is left out";
    spec.time_at_most.reset();
    spec.steps_at_most = 1;
    const Migration in_steps = migrate(cubic_lattice(5), spec);
    EXPECT_GT(in_steps.time, 0);
    EXPECT_LT(in_steps.time, 0.1 * spec.still_for) << "of one burst";
    EXPECT_FALSE(in_steps.result.holds.front().ended);
    EXPECT_EQ(in_steps.result.holds.front().ended_by, HoldEnd::StepLimit);
    spec.gradients.push_back(1);
    EXPECT_EQ(migrate(cubic_lattice(5), spec).cut_by, HoldEnd::StepLimit);
}

TEST(Migration, EndsAtItsLimitsThoughMotionIsLookedAtLater) {
    MigrateSpec spec = through_cubic_lattice();
    spec.gradients = {1e-3, 1e-3};
    spec.hold_at_most = 0.3 * spec.still_for;
    const Migration cut = migrate(cubic_lattice(5), spec);
    ASSERT_EQ(cut.result.holds.size(), 2U);
    for (const MigrationHold& hold : cut.result.holds) {
        EXPECT_NEAR(hold.held_for / spec.hold_at_most, 1, 0.05);
        EXPECT_FALSE(hold.ended) << "nothing moves, but that takes longer to see";
    }
    spec.time_at_most = 0.4 * spec.still_for;
    const Migration in_time = migrate(cubic_lattice(5), spec);
    EXPECT_EQ(in_time.result.holds.size(), 2U);
    EXPECT_NEAR(in_time.time / *spec.time_at_most, 1, 0.05);
}

TEST(Migration, GoesThroughItsGradientsOneAfterTheOther) {
    const Migration migration =
        migrate(dense_lattice(6), {.gradients = {1e-3, 2e-3, 1e-3}, .hold_at_most = 0.4, .gravity = Gravity{}});
    ASSERT_EQ(migration.result.holds.size(), 3U);
    double time = 0;
    for (const MigrationHold& hold : migration.result.holds) {
        EXPECT_TRUE(hold.ended);
        EXPECT_EQ(hold.eroded_mass_share, 0);
        time += hold.held_for;
    }
    EXPECT_NEAR(time, migration.time, 1e-12);
    EXPECT_EQ(migration.result.holds[1].gradient, 2e-3);
}

/// Sum of the normal forces that fines exert and bear [N].
double pressed_by_fines(const dem::World& world) {
    double sum = 0;
    for (const dem::ContactView& contact : dem::inspect_contacts(world)) {
        const bool is_theirs = world.grains.fine[contact.i] != 0 || world.grains.fine[contact.j] != 0;
        sum += is_theirs ? norm(contact.normal_force) : 0;
    }
    return sum;
}

TEST(Migration, LeavesASampleOfWhichNoneOfTheFinesPressesAnything) {
    dem::World wedge = dense_lattice(6); // the water presses fines into holes where friction would keep them pressed
    wedge.material.friction = 1;
    const Migration migration =
        migrate(wedge, {.gradients = {4}, .direction = {0.2, 0.1, 1}, .hold_at_most = 0.3, .gravity = Gravity{}});
    ASSERT_GT(pressed_by_fines(migration.world), 0);
    const dem::World after = migrated_sample(migration, {});
    EXPECT_LT(pressed_by_fines(after), 1e-3 * pressed_by_fines(migration.world));
    EXPECT_EQ(after.material.friction, wedge.material.friction);
    for (std::size_t g = 0; g < after.grains.size(); ++g) {
        const double way = norm(after.grains.position[g] - migration.world.grains.position[g]);
        EXPECT_LT(way, 0.1 * after.grains.radius[g]) << "pushed apart, not thrown";
    }
}

std::string refusal(const dem::World& world, const MigrateSpec& spec, const flow::Fluid& fluid = {}) {
    try {
        begin_migration(world, spec, {fluid, {}});
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Migration, NeedsWeightFinesACoarseSkeletonAndAnExitWithinTheCell) {
    const dem::World world = cubic_lattice(5);
    const MigrateSpec good{.gradients = {0.1}, .gravity = Gravity{}};
    MigrateSpec spec = good;
    spec.gravity.reset();
    EXPECT_NE(refusal(world, spec).find("[gravity]"), std::string::npos);
    spec = good;
    spec.gradients = {0.1, 0};
    EXPECT_NE(refusal(world, spec).find("above 0"), std::string::npos);
    spec = good;
    spec.exit = 2.1e-3;
    EXPECT_NE(refusal(world, spec).find("outside the cell, which is 0.002 m long"), std::string::npos);
    spec.exit = 1e-3;
    spec.direction = {1, 1, 0};
    EXPECT_NE(refusal(world, spec).find("at an angle"), std::string::npos);
    EXPECT_NE(refusal(world, good, {.viscosity = 0}).find("must be positive"), std::string::npos);
    spec = good;
    spec.skeleton = Skeleton::Moves; // which needs a stress to keep
    EXPECT_THROW(begin_migration(world, spec, {}), StateError);
    dem::World all_fine = world, none_fine = world;
    std::ranges::fill(all_fine.grains.fine, std::uint8_t{1});
    std::ranges::fill(none_fine.grains.fine, std::uint8_t{0});
    EXPECT_NE(refusal(all_fine, good).find("every grain is fine"), std::string::npos);
    EXPECT_NE(refusal(none_fine, good).find("no grain is fine"), std::string::npos);
}

TEST(Migration, LeavesByThePlaneOfItsExit) {
    const dem::World sample = cubic_lattice(100);
    for (const double exit : {0.5e-3, 2e-3}) {
        const Migration migration =
            begin_migration(sample, {.gradients = {0.1}, .exit = exit, .gravity = Gravity{}}, {});
        for (std::size_t k = 0; k < migration.ledger.size(); ++k) {
            const double plane = migration.ledger.start[k].z + migration.ledger.to_exit[k] - exit;
            EXPECT_NEAR(plane / 2e-3, std::round(plane / 2e-3), 1e-9) << "a period of the cell";
            EXPECT_GT(migration.ledger.to_exit[k], 0);
            EXPECT_LE(migration.ledger.to_exit[k], 2e-3);
        }
    }
}

} // namespace
} // namespace suffuse::erosion
