#include "suffuse/erosion/removal.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/erosion/extraction.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::erosion {
namespace {

constexpr double r = 0.5e-3;     // of the coarse grains [m]
constexpr double overlap = 2e-6; // between them [m]
constexpr double edge = 2 * r - overlap;

/// All passes.
RemovalResult remove_fines(dem::World& world, const RemoveSpec& spec = {}) {
    RemovalResult result = begin_removal(world, spec);
    PassUnderWay now;
    while (remove_once(world, spec, {}, result, now)) {
    }
    return result;
}

/// A simple cubic lattice of coarse grains, a fine one of `fine_radius` in the middle of each void, under the stress
/// that this lattice has, which the servo is to hold.
dem::World lattice(double fine_radius, double scale = 1, double coarse_radius = r) {
    constexpr int cells = 4;
    dem::World world;
    world.cell.h = cells * edge * scale * identity();
    for (int a = 0; a < cells; ++a) {
        for (int b = 0; b < cells; ++b) {
            for (int c = 0; c < cells; ++c) {
                const Vec3 corner = edge * Vec3{double(a), double(b), double(c)};
                add_grain(world.grains, scale * corner, scale * coarse_radius, 2600);
                add_grain(world.grains, scale * (corner + 0.5 * edge * Vec3{1, 1, 1}), scale * fine_radius, 2600);
                world.grains.fine[world.grains.size() - 1] = 1;
            }
        }
    }
    dem::StepCaches caches;
    dem::StepPlan plan;
    plan.dt = 1e-9 * scale;
    plan.loading = dem::constant_volume();
    dem::step(world, caches, plan); // finds the contacts
    const double p = dem::mean_stress(dem::mean_stress_tensor(world));
    world.servo.held_stress = {p, p, p};
    return world;
}

/// Of the coarse lattice alone: force E r x overlap on each edge squared [Pa].
double coarse_stress(const dem::World& world, double spacing) {
    return world.material.modulus * r * (2 * r - spacing) / (spacing * spacing);
}

TEST(Removal, OfFinesThatLieLooseChangesNothing) {
    dem::World world = lattice(0.3e-3); // the void takes 0.366 mm
    const double p = dem::mean_stress(dem::mean_stress_tensor(world));
    EXPECT_NEAR(p, coarse_stress(world, edge), 1e-9 * p); // rounding of positions of 4 mm against overlaps of 2 um
    const RemovalResult result = remove_fines(world);
    const PassResult& pass = result.erosion.passes.at(0);
    EXPECT_EQ(pass.removed, 64);
    EXPECT_EQ(world.grains.size(), 64U);
    EXPECT_NEAR(removed_share(world, result), std::pow(0.3, 3) / (std::pow(0.3, 3) + std::pow(0.5, 3)), 1e-12);
    EXPECT_NEAR(dem::mean_stress(pass.stress_constant_volume) / p, 1, 1e-9);
    // The servo follows the rounding of the stress: less than a millionth of the lattice's elastic strain.
    EXPECT_LE(std::abs(pass.volumetric_strain), 1e-6 * 3 * overlap / edge);
    EXPECT_FALSE(pass.verdict);
}

TEST(Removal, OfFinesThatCarryLoadLeavesTheStressOfTheCoarseLatticeAndThenItsStrain) {
    const double fine_radius = std::sqrt(0.75) * edge - r + 1e-6; // presses 1 um into its eight neighbors
    dem::World world = lattice(fine_radius);
    const double before = world.servo.held_stress.x;
    const double left = coarse_stress(world, edge);
    ASSERT_GT(before, 1.2 * left);
    const RemovalResult result = remove_fines(world);
    const PassResult& pass = result.erosion.passes.at(0);
    EXPECT_NEAR(dem::mean_stress(pass.stress_constant_volume) / left, 1, 1e-9);
    // Under the servo the spacing s falls until E r (2r - s)/s^2 is the stress before: s from the quadratic equation.
    const double k = world.material.modulus * r;
    const double spacing = (-k + std::sqrt(k * k + 8 * before * k * r)) / (2 * before);
    EXPECT_NEAR(pass.volumetric_strain, -3 * std::log(spacing / edge), 0.005 * 3 * overlap / edge * before / left);
    EXPECT_NEAR(removal_strain(world, result).x, pass.volumetric_strain / 3, 1e-9);
}

TEST(Removal, ResettlesInTheSameStepsByTheSameStrainWhateverTheSizeOfTheGrains) {
    const auto removed = [](double scale) {
        dem::World world = lattice(std::sqrt(0.75) * edge - r + 1e-6, scale);
        return remove_fines(world).erosion.passes.at(0);
    };
    const PassResult sand = removed(1), boulders = removed(128); // a power of two: the same bits
    EXPECT_EQ(sand.steps, boulders.steps);
    EXPECT_NEAR(boulders.volumetric_strain / sand.volumetric_strain, 1, 1e-12); // rounding of a cube root and a log
}

TEST(Removal, ResettlesTheMoreSlowlyTheSmallerTheSpecifiedInertialNumber) {
    const auto removed = [](double inertial_number) {
        dem::World world = lattice(std::sqrt(0.75) * edge - r + 1e-6);
        RemoveSpec spec;
        spec.resettle.inertial_number = inertial_number;
        return remove_fines(world, spec).erosion.passes.at(0);
    };
    const PassResult usual = removed(dem::loaded_inertial_number), slow = removed(dem::loaded_inertial_number / 8);
    EXPECT_GT(slow.steps, 2 * usual.steps);
    EXPECT_NEAR(
        slow.volumetric_strain / usual.volumetric_strain, 1, 0.01
    ); // a lattice: the same place, within the balance
}

TEST(Removal, NeedsASkeletonThatCarriesAStress) {
    dem::World world = lattice(0.3e-3);
    world.contacts = {};
    EXPECT_THROW(remove_fines(world), StateError);
}

TEST(Removal, TakesTheSpecifiedClass) {
    const dem::World pressed = lattice(std::sqrt(0.75) * edge - r + 1e-6), loose = lattice(0.3e-3);
    EXPECT_EQ(fines_to_remove(pressed, RemovedFines::Active).size(), 64U);
    EXPECT_EQ(fines_to_remove(pressed, RemovedFines::Inactive).size(), 0U);
    EXPECT_EQ(fines_to_remove(loose, RemovedFines::Active).size(), 0U);
    EXPECT_EQ(fines_to_remove(loose, RemovedFines::Inactive).size(), 64U);
    EXPECT_EQ(fines_to_remove(loose, RemovedFines::All).size(), 64U);
}

TEST(Removal, ASkeletonThatStrainsTooFarHasFailedAndTheStageEnds) {
    const double fine_radius = std::sqrt(0.75) * edge - r + 1e-6;
    dem::World world = lattice(fine_radius);
    RemoveSpec spec;
    spec.resettle.max_strain = 1e-6; // less than the lattice needs
    const RemovalResult result = remove_fines(world, spec);
    EXPECT_TRUE(std::holds_alternative<SkeletonFailed>(result.erosion.passes.at(0).verdict.why));
    EXPECT_TRUE(result.erosion.passes.at(0).failed);
    EXPECT_EQ(world.grains.size(), 64U);
}

TEST(Removal, ASkeletonThatFindsNoRestHasFailedAndItsStateIsKept) {
    const double small = r - overlap; // the fines alone hold the coarse grains, which touch nowhere
    dem::World world = lattice(std::sqrt(0.75) * edge - small + 1e-6, 1, small);
    RemoveSpec spec;
    spec.resettle.inertial_number = 1e-9; // too slow to find another
    const RemovalResult result = remove_fines(world, spec);
    const PassResult& pass = result.erosion.passes.at(0);
    EXPECT_TRUE(pass.failed);
    ASSERT_TRUE(std::holds_alternative<SkeletonRestless>(pass.verdict.why));
    EXPECT_LT(std::get<SkeletonRestless>(pass.verdict.why).steps, 500'000) << "not after millions of steps";
    EXPECT_NEAR(std::get<SkeletonRestless>(pass.verdict.why).carried, 0, 1e-9);
    EXPECT_GT(pass.porosity_after, pass.porosity_before);
    EXPECT_EQ(world.grains.size(), 64U);
}

TEST(Removal, InPassesTakesEqualPartsOfTheShareToWithinAGrain) {
    dem::World world = lattice(0.3e-3);
    const double fines = 64 * world.grains.mass[1], all = total_mass(world.grains);
    RemoveSpec spec;
    spec.share = 0.5;
    spec.passes = 3;
    const RemovalResult result = remove_fines(world, spec);
    ASSERT_EQ(result.erosion.passes.size(), 3U);
    double gone = 0;
    for (const PassResult& pass : result.erosion.passes) {
        gone += pass.eroded_mass_percent_of_initial / 100 * all;
        EXPECT_NEAR(gone, 0.5 * fines * pass.pass / 3, 0.5 * fines / 64 * (1 + 1e-9)) << pass.pass; // half a grain
    }
    EXPECT_NEAR(gone, 0.5 * fines, 1e-12 * fines);
    EXPECT_EQ(result.erosion.ledger.size(), 32U);
    EXPECT_EQ(result.erosion.ledger.back().pass, 3);
    EXPECT_EQ(result.erosion.path.back().pass, 3);
    EXPECT_NEAR(result.erosion.path.back().eroded_mass, gone / all, 1e-12);
}

TEST(Removal, OfTheWholeShareInPassesEndsWithAllGone) {
    dem::World world = lattice(0.3e-3);
    RemoveSpec spec;
    spec.passes = 7;
    spec.order = RemovalOrder::FewestContacts;
    const RemovalResult result = remove_fines(world, spec);
    EXPECT_TRUE(fines_to_remove(world, RemovedFines::All).empty());
    EXPECT_EQ(result.erosion.passes.size(), 7U);
    EXPECT_FALSE(result.erosion.passes.back().verdict);
}

TEST(Removal, LooksAtTheClassAnewInEachPassAndEndsWhenNoneIsLeft) {
    const double fine_radius = std::sqrt(0.75) * edge - r + 1e-6; // presses 1 um into its eight neighbors
    dem::World world = lattice(fine_radius);
    world.grains.radius[1] = 0.3e-3; // lies loose: the only one without contacts
    dem::StepCaches caches;
    dem::StepPlan plan;
    plan.dt = 1e-9;
    plan.loading = dem::constant_volume();
    dem::step(world, caches, plan);
    ASSERT_EQ(fines_to_remove(world, RemovedFines::Inactive).size(), 1U);
    RemoveSpec spec;
    spec.grains = RemovedFines::Inactive;
    spec.passes = 4;
    const RemovalResult result = remove_fines(world, spec);
    ASSERT_EQ(result.erosion.ledger.size(), 1U);
    EXPECT_EQ(result.erosion.ledger[0].reason, Reason::RemovedInactive);
    EXPECT_TRUE(std::holds_alternative<NoneToRemove>(result.erosion.passes.back().verdict.why));
    EXPECT_FALSE(result.erosion.passes.back().failed);
}

TEST(Removal, ByChanceTakesTheSameGrainsForTheSameSeedOnly) {
    RemoveSpec spec;
    spec.share = 0.5;
    const auto taken = [&](std::uint64_t seed) {
        dem::World world = lattice(0.3e-3);
        world.seed = seed;
        std::vector<std::uint32_t> ids;
        for (const LedgerRow& row : remove_fines(world, spec).erosion.ledger) {
            ids.push_back(row.grain);
        }
        return std::pair(ids, dem::state_hash(world));
    };
    EXPECT_EQ(taken(1), taken(1));
    EXPECT_NE(taken(1).first, taken(2).first);
}

TEST(Removal, OfASampleOfFinesAloneIsRefused) {
    dem::World world = lattice(0.3e-3);
    for (auto& fine : world.grains.fine) {
        fine = 1;
    }
    EXPECT_THROW(remove_fines(world), StateError);
    EXPECT_EQ(world.grains.size(), 128U);
}

} // namespace
} // namespace suffuse::erosion
