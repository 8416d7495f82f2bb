// Throats of lattices, which are known.

#include "suffuse/erosion/passed_throats.hpp"

#include "suffuse/base/random.hpp"
#include "suffuse/erosion/migration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace suffuse::erosion {
namespace {

constexpr double coarse_diameter = 1e-3; // [m]

void add_coarse(dem::World& world, const Vec3& place) {
    add_grain(world.grains, place, coarse_diameter / 2, world.material.density);
}

/// Coarse grains at the corners of cubes, which just touch: windows are squares in the planes x, y or z = k D.
dem::World cubic_lattice() {
    constexpr int edge = 3;
    dem::World world;
    world.cell.h = diagonal(edge * coarse_diameter * Vec3{1, 1, 1});
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 corner{
            static_cast<double>(k % edge), static_cast<double>(k / edge % edge), static_cast<double>(k / edge / edge)};
        add_coarse(world, coarse_diameter * corner);
    }
    return world;
}

/// Planes of windows between two places.
int planes_between(const Vec3& from, const Vec3& to) {
    int planes = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cube = [&](const Vec3& x) { return static_cast<int>(std::floor(x[axis] / coarse_diameter)); };
        planes += std::abs(cube(to) - cube(from));
    }
    return planes;
}

TEST(PassedThroats, OfACubicLatticeAreTheWindowsOnTheWay) {
    const dem::World world = cubic_lattice();
    constexpr std::size_t ways = 200;
    RandomStream random(1, "ways through a lattice");
    std::vector<Vec3> from, way;
    for (std::size_t k = 0; k < ways; ++k) {
        from.push_back(world.cell.h * Vec3{random.uniform(), random.uniform(), random.uniform()});
        way.push_back(3 * (world.cell.h * Vec3{random.uniform(), random.uniform(), random.uniform()}));
    }
    CoarseThroats at_once(world, from), in_steps(world, from);
    int all = 0;
    for (std::size_t k = 0; k < ways; ++k) {
        PassedThroats once, steps;
        at_once.follow(k, from[k] + way[k], once);
        constexpr int parts = 50;
        for (int part = 1; part <= parts; ++part) {
            in_steps.follow(k, from[k] + part / static_cast<double>(parts) * way[k], steps);
        }
        EXPECT_EQ(once.count, planes_between(from[k], from[k] + way[k]));
        EXPECT_EQ(steps.count, once.count) << "however often it is looked at";
        if (once.count > 0) { // through the middle of four grains, the most open place of the window
            EXPECT_NEAR(once.narrowest / coarse_diameter, std::sqrt(2.0) - 1, 1e-9);
        }
        all += once.count;
    }
    EXPECT_GT(all, 500);
}

TEST(PassedThroats, DoNotCountOneThatAGrainComesBackThrough) {
    const dem::World world = cubic_lattice();
    const Vec3 before{0.5e-3, 0.6e-3, 0.9e-3}, behind{0.5e-3, 0.6e-3, 1.1e-3};
    CoarseThroats throats(world, std::vector<Vec3>{before});
    PassedThroats passed;
    for (int k = 0; k < 5; ++k) {
        throats.follow(0, behind, passed);
        EXPECT_EQ(passed.count, 1);
        throats.follow(0, before, passed);
        EXPECT_EQ(passed.count, 0);
    }
    EXPECT_GT(passed.narrowest, 0) << "it has been there all the same";
}

TEST(PassedThroats, OfTheDensestLatticeAreHolesBetweenThreeGrains) {
    // From an octahedral void through a hole of three grains into the tetrahedral one, and out of it.
    constexpr int edge = 2;
    const double cube = std::sqrt(2.0) * coarse_diameter;
    dem::World world;
    world.cell.h = diagonal(edge * cube * Vec3{1, 1, 1});
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 corner{
            static_cast<double>(k % edge), static_cast<double>(k / edge % edge), static_cast<double>(k / edge / edge)};
        for (const Vec3& place : {Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0}, Vec3{0.5, 0, 0.5}, Vec3{0, 0.5, 0.5}}) {
            add_coarse(world, cube * (corner + place));
        }
    }
    const Vec3 octahedral = cube * Vec3{0.5, 0.5, 0.5}, tetrahedral = cube * Vec3{0.75, 0.75, 0.75};
    CoarseThroats throats(world, std::vector<Vec3>{octahedral});
    PassedThroats passed;
    throats.follow(0, tetrahedral, passed);
    EXPECT_EQ(passed.count, 1);
    EXPECT_NEAR(passed.narrowest / coarse_diameter, 2 / std::sqrt(3.0) - 1, 1e-9);
    throats.follow(0, cube * Vec3{1, 1, 0.5}, passed); // the next octahedral void
    EXPECT_EQ(passed.count, 2);
}

TEST(PassedThroats, OfFinesThatMigrateAreThoseBetweenTheirFirstPlaceAndTheirLast) {
    dem::World sample = cubic_lattice();
    const std::size_t coarse = sample.grains.size();
    for (std::size_t g = 0; g < coarse; ++g) {
        const Vec3 middle = sample.grains.position[g] + 0.5 * coarse_diameter * Vec3{1, 1, 1};
        sample.grains.fine[add_grain(sample.grains, middle, 0.1 * coarse_diameter, sample.material.density)] = 1;
    }
    const MigrateSpec spec{.gradients = {0.3}, .exit = 2.4e-3, .hold_at_most = 0.3, .gravity = Gravity{}};
    Migration migration = begin_migration(sample, spec, {});
    while (!migration.over) {
        migrate_on(migration, spec, {});
    }
    const MigrationLedger& ledger = migration.ledger;
    int most = 0;
    for (std::size_t k = 0; k < ledger.size(); ++k) {
        EXPECT_EQ(ledger.passed[k].count, planes_between(ledger.start[k], ledger.end[k])) << k;
        most = std::max(most, ledger.passed[k].count);
    }
    EXPECT_GE(most, 2);
}

} // namespace
} // namespace suffuse::erosion
