// The skeleton that fines leave: what it carries, and how it settles.

#include "suffuse/base/error.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/erosion/migration.hpp"

#include <gtest/gtest.h>

#include "tests/support/migrations.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

namespace suffuse::erosion {
namespace {

using test::migrate;

/// A random packing under stress, whose contacts are known, and in its pores fines that fit through all throats.
dem::World stressed_packing() {
    dem::World world = test::reference_packing("packing500");
    const grains::Grains coarse = world.grains;
    const double d = 0.25 * 2 * *std::ranges::min_element(coarse.radius);
    RandomStream random(1, "fines in pores");
    const Mat3 h = world.cell.h;
    const Vec3 half = h * Vec3{0.5, 0.5, 0.5};
    for (int added = 0; added < 20;) {
        const Vec3 place = h * Vec3{random.uniform(), random.uniform(), random.uniform()};
        bool is_free = true;
        for (std::size_t g = 0; g < coarse.size(); ++g) {
            const Vec3 apart = cell::wrapped(h, inverse(h), coarse.position[g] - place + half) - half;
            is_free = is_free && norm(apart) > coarse.radius[g] + d;
        }
        if (is_free) {
            add_grain(world.grains, place, d / 2, world.material.density);
            world.grains.fine.back() = 1;
            ++added;
        }
    }
    dem::StepCaches caches;
    dem::step(world, caches, test::plan_of(1e-9));
    return world;
}

MigrateSpec with_moving_skeleton() {
    return {
        .gradients = {0.5, 4},
        .exit = 0.2e-3,
        .skeleton = Skeleton::Moves,
        .hold_at_most = 0.02,
        .still_for = 0.01,
        .gravity = Gravity{}};
}

TEST(Migration, BetweenGradientsLetsTheSkeletonFindItsStressAgain) {
    const dem::World sample = stressed_packing();
    const Surroundings around{.balance = {1e-2, 50}};
    const Migration migration = migrate(sample, with_moving_skeleton(), around);
    ASSERT_EQ(migration.result.holds.size(), 2U);
    const double before = dem::mean_stress(dem::mean_stress_tensor(sample));
    double porosity = dem::porosity(sample);
    for (const MigrationHold& hold : migration.result.holds) {
        EXPECT_FALSE(hold.failed);
        EXPECT_GT(hold.stress_kept, 0.5);
        EXPECT_LT(hold.stress_kept, 1.05);
        EXPECT_GT(hold.volumetric_strain, -1e-3) << "without grains it may only give way";
        EXPECT_LT(hold.volumetric_strain, 0.05);
        porosity = hold.porosity;
    }
    const dem::World after = migrated_sample(migration, {});
    EXPECT_NEAR(dem::mean_stress(dem::mean_stress_tensor(after)) / before, 1, 0.03); // the balance requires 1 % an axis
    EXPECT_NEAR(dem::porosity(after), porosity, 1e-12);
    EXPECT_NEAR((total_mass(after.grains) + eroded_mass(migration.ledger)) / total_mass(sample.grains), 1, 1e-13);
    EXPECT_GT(eroded_mass(migration.ledger), 0);
    for (std::size_t k = 0; k < migration.ledger.size(); ++k) {
        const double way = norm(migration.ledger.end[k] - migration.ledger.start[k]);
        EXPECT_TRUE(migration.ledger.where[k] != Whereabouts::Stayed || way <= 0.5 * migration.ledger.diameter[k]);
    }
}

TEST(Migration, LeavesAHeldSkeletonWithTheStressAndTheBalanceOfBefore) {
    const dem::World sample = stressed_packing();
    const MigrateSpec spec{.gradients = {4}, .exit = 0.2e-3, .hold_at_most = 0.05, .gravity = Gravity{}};
    const dem::World after = migrated_sample(migrate(sample, spec), {});
    const double stress = dem::mean_stress(dem::mean_stress_tensor(sample));
    EXPECT_NEAR(dem::mean_stress(dem::mean_stress_tensor(after)) / stress, 1, 1e-3);
    const double unbalanced = dem::measure_equilibrium(sample).unbalanced_force;
    EXPECT_NEAR(dem::measure_equilibrium(after).unbalanced_force / unbalanced, 1, 0.05);
}

TEST(Migration, WhoseSkeletonMovesGoesOnFromAnyOfItsStates) {
    const dem::World sample = stressed_packing();
    const Surroundings around{.balance = {1e-2, 50}};
    MigrateSpec spec = with_moving_skeleton();
    spec.gradients = {4};
    Migration straight = begin_migration(sample, spec, around);
    while (!straight.settles) {
        migrate_on(straight, spec, around);
    }
    Migration stopped = straight;
    int beats = 0;
    const Surroundings impatient{.balance = around.balance, .pulse = [&](std::string_view, long long) {
                                     if (++beats > 20) {
                                         throw Interrupted("enough");
                                     }
                                 }};
    EXPECT_THROW(migrate_on(stopped, spec, impatient), Interrupted);
    EXPECT_TRUE(stopped.settles && stopped.steps == straight.steps) << "as it was before the call";
    migrate_on(straight, spec, around);
    migrate_on(stopped, spec, around);
    EXPECT_TRUE(straight.over);
    EXPECT_EQ(dem::state_hash(straight.world), dem::state_hash(stopped.world));
}

TEST(Migration, WhoseSkeletonMovesSettlesWhenAllFinesHaveLeft) {
    const dem::World sample = stressed_packing();
    const Surroundings around{.balance = {1e-2, 50}};
    MigrateSpec spec = with_moving_skeleton();
    Migration migration = begin_migration(sample, spec, around);
    migration.settles = true;
    std::vector<std::uint32_t> fines;
    for (std::uint32_t g = 0; g < migration.world.grains.size(); ++g) {
        if (migration.world.grains.fine[g] != 0) {
            fines.push_back(g);
        }
    }
    dem::remove_grains(migration.world, fines);
    std::ranges::fill(migration.ledger.where, Whereabouts::Eroded);
    migrate_on(migration, spec, around);
    EXPECT_TRUE(migration.over);
    const dem::World after = migrated_sample(migration, {});
    const double before = dem::mean_stress(dem::mean_stress_tensor(sample));
    EXPECT_NEAR(dem::mean_stress(dem::mean_stress_tensor(after)) / before, 1, 0.03);
}

} // namespace
} // namespace suffuse::erosion
