#include "suffuse/erosion/extraction.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/erosion/passage.hpp"

#include <gtest/gtest.h>

namespace suffuse::erosion {
namespace {

dem::World four_grains() {
    dem::World world;
    world.cell.h = diagonal({1, 1, 1});
    for (int g = 0; g < 4; ++g) {
        add_grain(world.grains, {0.1 + 0.2 * g, 0.5, 0.5}, 0.01 * (g + 1), 2600);
    }
    world.grains.fine = {1, 1, 0, 0};
    return world;
}

TEST(Extraction, WhatLeavesIsInTheLedgerAndNothingElse) {
    dem::World world = four_grains();
    ErosionResult so_far;
    so_far.initial_mass = total_mass(world.grains);
    PassResult pass;
    pass.pass = 2;
    const auto ledger =
        extract(world, std::vector<std::uint32_t>{1}, std::vector<int>{0, 3, 0, 0}, Reason::Velocity, so_far, pass);
    ASSERT_EQ(ledger.size(), 1U);
    EXPECT_EQ(ledger[0].grain, 1U);
    EXPECT_EQ(ledger[0].pass, 2);
    EXPECT_EQ(ledger[0].coordination, 3);
    EXPECT_EQ(ledger[0].diameter, 0.04);
    EXPECT_EQ(world.grains.id, (std::vector<std::uint32_t>{0, 2, 3}));
    EXPECT_EQ(pass.removed, 1);
    EXPECT_EQ(pass.coordination_histogram, (std::map<int, std::int64_t>{{3, 1}}));
    EXPECT_NEAR(pass.eroded_mass_percent, 8, 1e-12); // of 1 + 8 + 27 + 64; rounding
    EXPECT_NEAR(pass.eroded_mass_percent_of_initial, 8, 1e-12);
    EXPECT_NO_THROW(check_ledger(world, ledger, so_far.initial_mass));
}

TEST(Extraction, ALedgerThatMissesOrRepeatsAGrainIsADefect) {
    dem::World world = four_grains();
    ErosionResult so_far;
    const double mass = so_far.initial_mass = total_mass(world.grains);
    PassResult pass;
    const auto ledger =
        extract(world, std::vector<std::uint32_t>{0, 1}, std::vector<int>(4), Reason::Velocity, so_far, pass);
    std::vector<LedgerRow> missing(ledger.begin(), ledger.begin() + 1), repeated = ledger;
    repeated.push_back(ledger.front());
    EXPECT_THROW(check_ledger(world, missing, mass), Bug);
    EXPECT_THROW(check_ledger(world, repeated, mass), Bug);
}

TEST(Extraction, ALedgerBalancesToATenthOfABillionth) {
    const dem::World world = four_grains();
    const double mass = total_mass(world.grains);
    EXPECT_NO_THROW(check_ledger(world, {}, mass * (1 + 0.5e-10)));
    EXPECT_THROW(check_ledger(world, {}, mass * (1 + 2e-10)), Bug);
    EXPECT_THROW(check_ledger(world, {}, mass * (1 - 2e-10)), Bug);
}

TEST(Extraction, FinesContentIsByMass) {
    const double fine = 1 + 8, all = 1 + 8 + 27 + 64;
    EXPECT_NEAR(fines_content(four_grains().grains), fine / all, 1e-14);
}

TEST(Passage, AGrainPassesWhatIsWiderThanItself) {
    CoarseSkeleton skeleton;
    EXPECT_TRUE(passes(skeleton, ConstrictionSize::Mean, 0, 400)); // no constriction is left: all pores are one void
    skeleton.constrictions.diameter = {1, 2, 6};
    skeleton.constrictions.mean = 3;
    skeleton.constrictions.median = 2;
    skeleton.constrictions.d35 = 1;
    skeleton.widest_path = {5, 0.5};
    EXPECT_TRUE(passes(skeleton, ConstrictionSize::Mean, 0, 2.9));
    EXPECT_FALSE(passes(skeleton, ConstrictionSize::Mean, 0, 3));
    EXPECT_FALSE(passes(skeleton, ConstrictionSize::Median, 0, 2.9));
    EXPECT_FALSE(passes(skeleton, ConstrictionSize::D35, 0, 1.5));
    EXPECT_TRUE(passes(skeleton, ConstrictionSize::WidestPath, 0, 4));
    EXPECT_FALSE(passes(skeleton, ConstrictionSize::WidestPath, 1, 4));
    EXPECT_TRUE(passes(skeleton, ConstrictionSize::None, 1, 400));
}

/// A simple cubic lattice of coarse grains with a fine one in every void.
dem::World lattice_with_fines(int cells) {
    dem::World world;
    const double r = 0.5e-3;
    world.cell.h = 2 * r * cells * identity();
    for (int a = 0; a < cells; ++a) {
        for (int b = 0; b < cells; ++b) {
            for (int c = 0; c < cells; ++c) {
                const Vec3 corner = 2 * r * Vec3{double(a), double(b), double(c)};
                add_grain(world.grains, corner, r, 2600);
                add_grain(world.grains, corner + r * Vec3{1, 1, 1}, 0.1 * r, 2600);
                world.grains.fine[world.grains.size() - 1] = 1;
            }
        }
    }
    return world;
}

TEST(Passage, TheWidestPathThroughASimpleCubicSkeletonIsItsSquareWindow) {
    const dem::World world = lattice_with_fines(4);
    const CoarseSkeleton skeleton = measure_coarse_skeleton(world, {0, 0, 1}, true);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        EXPECT_NEAR(skeleton.widest_path[g], 2 * (std::sqrt(2.0) - 1) * 0.5e-3, 1e-9);
    }
}

TEST(Passage, MergedVoidsOfASimpleCubicSkeletonHaveEachSquareWindowOnce) {
    const dem::World world = lattice_with_fines(4);
    const double window = 2 * (std::sqrt(2.0) - 1) * 0.5e-3;
    for (const pores::VoidMerge merge : pores::every_merge) {
        const std::int64_t expected = (merge == pores::VoidMerge::None ? 6 : 3) * 64; // or each of its two halves
        const CoarseSkeleton skeleton = measure_coarse_skeleton(world, {0, 0, 1}, false, merge);
        EXPECT_EQ(std::ssize(skeleton.constrictions.diameter), expected);
        const ConstrictionSummary& summary = skeleton.by_merge[static_cast<std::size_t>(merge)];
        EXPECT_EQ(summary.count, expected);
        EXPECT_NEAR(summary.mean, window, 1e-12 * window); // rounding
        EXPECT_EQ(summary.mean, skeleton.constrictions.mean);
        EXPECT_EQ(skeleton.by_merge[1].count, 3 * 64); // reported for every way, whichever was requested
    }
}

TEST(Passage, TooFewOrTooLargeCoarseGrainsAreACause) {
    EXPECT_FALSE(doubt_skeleton(lattice_with_fines(6)).has_value());
    EXPECT_TRUE(doubt_skeleton(lattice_with_fines(4)).has_value()); // a cell of four diameters
    EXPECT_TRUE(doubt_skeleton(lattice_with_fines(3)).has_value()); // 27 grains
}

TEST(Passage, ASkeletonIsDoubtedBelowFiftyGrainsAndBelowFiveOfItsDiameters) {
    const auto is_doubted = [](int grains, double diameters) {
        dem::World world;
        world.cell.h = diagonal({2 * diameters, 20, 20}); // of grains of radius 1
        for (int g = 0; g < grains; ++g) {
            add_grain(world.grains, {0, 0, 0}, 1, 2600);
        }
        world.grains.fine.assign(world.grains.size(), 0);
        return doubt_skeleton(world).has_value();
    };
    EXPECT_TRUE(is_doubted(49, 6));
    EXPECT_FALSE(is_doubted(50, 6));
    EXPECT_TRUE(is_doubted(50, 4.9));
    EXPECT_FALSE(is_doubted(50, 5.1));
}

} // namespace
} // namespace suffuse::erosion
