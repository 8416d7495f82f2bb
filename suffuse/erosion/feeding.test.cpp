// Fines that enter with the water: as much as it brings, where it enters.

#include "suffuse/erosion/feeding.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/erosion/migration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace suffuse::erosion {
namespace {

/// A cubic lattice of touching coarse grains, and a small fine grain in every other of its voids, of two sizes.
dem::World lattice_to_feed() {
    constexpr int edge = 2;
    const double D = 1e-3;
    dem::World world;
    world.seed = 7;
    world.cell.h = diagonal({edge * D, edge * D, edge * D});
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 corner{k % edge + 0.5, k / edge % edge + 0.5, k / edge / edge + 0.5};
        add_grain(world.grains, D * corner, D / 2, world.material.density);
        const double d = k % 4 < 2 ? D / 6 : D / 8;
        const Vec3 middle = D * (corner + Vec3{0.5, 0.5, 0.5});
        world.grains.fine[add_grain(world.grains, middle, d / 2, world.material.density)] = 1;
    }
    return world;
}

/// About thirty grains in the time of the hold.
MigrateSpec with_feed() {
    return {.gradients = {0.3}, .exit = 0.8e-3, .hold_at_most = 0.15, .feed = 40, .gravity = Gravity{}};
}

Migration feed_and_migrate(const dem::World& sample, const MigrateSpec& spec, bool with_copies = false) {
    Migration migration = begin_migration(sample, spec, {});
    while (!migration.over) {
        if (with_copies) {
            Migration copy = migration;
            migrate_on(copy, spec, {});
            migration = copy;
        } else {
            migrate_on(migration, spec, {});
        }
    }
    return migration;
}

TEST(Feeding, LetsEnterWhatTheWaterBringsAndKeepsTheMass) {
    const dem::World sample = lattice_to_feed();
    const MigrateSpec spec = with_feed();
    const Migration migration = feed_and_migrate(sample, spec);
    const MigrationLedger& ledger = migration.ledger;
    // Water: what each row's permeability lets through a square of 2 mm in its time.
    const flow::Fluid fluid;
    double water = 0, before = 0;
    for (const MigrationRow& row : migration.result.rows) {
        const double velocity = row.permeability * fluid.density * gravity * 0.3 / fluid.viscosity;
        water += velocity * 4e-6 * (row.time - before);
        before = row.time;
    }
    EXPECT_NEAR((migration.fed_mass + migration.feeding.waiting) / (40 * water), 1, 1e-9);
    EXPECT_LT(migration.feeding.waiting, *std::ranges::max_element(ledger.mass)) << "less than a grain waits";
    EXPECT_GT(migration.feeding.drawn, 10);
    double of_rows = 0;
    std::set<std::uint32_t> ids;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        of_rows += ledger.entered[k] < 0 ? 0 : ledger.mass[k];
        ids.insert(ledger.id[k]);
    }
    EXPECT_EQ(ids.size(), ledger.size());
    EXPECT_NEAR(of_rows / migration.fed_mass, 1, 1e-14);
    EXPECT_EQ(migration.result.rows.back().fed_mass, migration.fed_mass);
    const double after = total_mass(migrated_sample(migration, {}).grains) + eroded_mass(ledger);
    EXPECT_NEAR(after / (total_mass(sample.grains) + migration.fed_mass), 1, 1e-14);
    std::size_t through = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        through += ledger.entered[k] >= 0 && ledger.left[k] > ledger.entered[k] ? 1 : 0;
    }
    EXPECT_GT(through, 0U) << "grains that entered leave, too";
}

TEST(Feeding, PlacesGrainsOfTheSamplesSizesBehindTheFace) {
    const Migration migration = feed_and_migrate(lattice_to_feed(), with_feed());
    const MigrationLedger& ledger = migration.ledger;
    std::size_t large = 0, entered = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        if (ledger.entered[k] >= 0) {
            const double r = 0.5 * ledger.diameter[k];
            EXPECT_NEAR(ledger.start[k].z, r, 1e-12);
            EXPECT_NEAR(ledger.to_exit[k], 0.8e-3 - r, 1e-12);
            large += r > 0.07e-3 ? 1 : 0;
            ++entered;
            EXPECT_TRUE(std::ranges::find(ledger.diameter, ledger.diameter[k]) - ledger.diameter.begin() < 8);
        }
    }
    EXPECT_GT(large, 0.2 * static_cast<double>(entered)); // a half of the sample's
    EXPECT_LT(large, 0.8 * static_cast<double>(entered));
}

TEST(Feeding, HasTheSameBitsForAnyNumberOfThreadsAndFromAnyState) {
    const int threads = thread_count();
    set_thread_count(1);
    const Migration one = feed_and_migrate(lattice_to_feed(), with_feed());
    set_thread_count(3);
    const Migration three = feed_and_migrate(lattice_to_feed(), with_feed(), true);
    set_thread_count(threads);
    EXPECT_EQ(one.ledger.end, three.ledger.end);
    EXPECT_EQ(one.ledger.entered, three.ledger.entered);
    EXPECT_EQ(dem::state_hash(one.world), dem::state_hash(three.world));
}

TEST(Feeding, WaitsWhereTheFaceIsFull) {
    dem::World world = lattice_to_feed();
    Migration migration = begin_migration(world, with_feed(), {});
    const std::size_t before = migration.ledger.size();
    const double fed = feed_fines(migration.world, migration.ledger, migration.feeding, with_feed(), 1, 0.5);
    EXPECT_GT(migration.ledger.size(), before + 5) << "water that brings 40 kg fills the face";
    EXPECT_LT(migration.ledger.size(), before + 500);
    EXPECT_NEAR(fed + migration.feeding.waiting, 40, 1e-9);
}

TEST(Feeding, GoesOnWithWaterAloneUntilThatBringsFines) {
    MigrateSpec spec = with_feed();
    spec.gradients = {1};
    spec.exit = 0.02e-3; // nearly where it enters: what comes in is out at once
    spec.feed = 1;
    dem::World sample = lattice_to_feed();
    sample.material.friction = 0; // nothing lodges
    const Migration migration = feed_and_migrate(sample, spec);
    const MigrationHold& hold = migration.result.holds.back();
    EXPECT_NEAR(hold.held_for / spec.hold_at_most, 1, 0.05);
    EXPECT_EQ(hold.ended_by, HoldEnd::HoldLimit) << "more could come";
    EXPECT_FALSE(hold.ended);
    bool was_empty = false;
    for (const MigrationRow& row : migration.result.rows) {
        EXPECT_NEAR(row.base_gradient / row.gradient, 1, 1e-12) << "of water alone, too";
        was_empty = was_empty || row.eroded_mass >= (migration.result.fines_mass + row.fed_mass) * (1 - 1e-12);
    }
    EXPECT_TRUE(was_empty);
    EXPECT_GT(migration.fed_mass, 0);
    EXPECT_NEAR(own_eroded_mass(migration.ledger), migration.result.fines_mass, 1e-12 * migration.result.fines_mass);
    EXPECT_GT(eroded_mass(migration.ledger), 1.1 * migration.result.fines_mass);
}

TEST(Feeding, IsNotForAStack) {
    MigrateSpec spec = with_feed();
    spec.stack = true;
    EXPECT_THROW(begin_migration(lattice_to_feed(), spec, {}), CaseError);
}

} // namespace
} // namespace suffuse::erosion
