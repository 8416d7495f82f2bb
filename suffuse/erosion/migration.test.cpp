// Fines in true time: closed forms of one grain, and what many of them keep.

#include "suffuse/erosion/migration.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/erosion/grain_water.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace suffuse::erosion {
namespace {

constexpr double fine_diameter = 0.1e-3, wide = 4e-3; // [m]

/// A fine grain in a wide cell, and a coarse one far from it.
dem::World one_in_wide_water(double diameter = fine_diameter) {
    dem::World world;
    world.cell.h = diagonal({wide, wide, wide});
    add_grain(world.grains, {0.1 * wide, 0.1 * wide, 0.5 * wide}, 0.3e-3, world.material.density);
    add_grain(world.grains, {0.6 * wide, 0.6 * wide, 0.5 * wide}, diameter / 2, world.material.density);
    world.grains.fine = {0, 1};
    return world;
}

[[maybe_unused]] Migration migrate(const dem::World& sample, const MigrateSpec& spec, const flow::Fluid& fluid = {}) {
    Migration migration = begin_migration(sample, spec, {fluid, {}});
    while (!migration.over) {
        migrate_on(migration, spec, {fluid, {}});
    }
    return migration;
}

TEST(Migration, OfOneGrainInStillWaterIsItsSinkingAtTheVelocityOfStokes) {
    for (const double diameter : {fine_diameter, fine_diameter / 2}) {
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
        std::printf("d %g v %g stokes %g ratio %g hindrance %g K %g dt %g steps %ld rows %zu t %g\n", diameter, velocity, stokes, velocity/stokes, migration.hindrance, migration.scale.factor, migration.time_step, (long)migration.steps, migration.rows.size(), migration.time);
        EXPECT_NEAR(velocity / stokes, 1, 0.01);
    }
}

} // namespace
} // namespace suffuse::erosion
