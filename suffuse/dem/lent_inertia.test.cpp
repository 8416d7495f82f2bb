#include "suffuse/dem/lent_inertia.hpp"

#include "suffuse/dem/stable_dt.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::dem {
namespace {

constexpr double median = 0.4e-3; // diameter [m]

/// Grains of a tenth of the median size up to twice it.
World graded() {
    World world = test::empty_world(1e-2);
    for (const double size : {0.1, 0.13, 0.35, 0.77, 1.0, 2.0}) {
        test::add(world, {}, size * median / 2);
    }
    return world;
}

/// Of two grains like grain `g` [rad/s].
double frequency_of_two(const World& world, std::size_t g) {
    const Inertia grain{world.grains.radius[g], world.grains.mass[g], world.grains.inertia[g]};
    return pair_frequency(world.material, world.material.shear_ratio, grain, grain);
}

TEST(LentInertia, MakesPairsOfSmallGrainsAsQuickAsThatOfTheMedianGrainWithinItsPowerOfTwo) {
    World world = graded(), median_grain = test::empty_world(1e-2);
    test::add(median_grain, {}, median / 2);
    const double own = frequency_of_two(world, 0), wanted = frequency_of_two(median_grain, 0);
    EXPECT_NEAR(own / wanted, 10, 1e-9);
    lend_inertia(world, median, {}, {true, false});
    for (std::size_t g = 0; g < 5; ++g) { // up to the median size
        EXPECT_GE(frequency_of_two(world, g), wanted * (1 - 1e-12)) << g;
        EXPECT_LE(frequency_of_two(world, g), wanted * std::sqrt(2)) << g;
    }
}

TEST(LentInertia, LetsNoSmallGrainRollOnTheLargestQuickerThanTheMedianGrainDoes) {
    World world = graded();
    lend_inertia(world, median, {}, {true, true});
    const auto rolling_on_the_largest = [&](std::size_t g) {
        const auto of = [&](std::size_t k) {
            return Inertia{world.grains.radius[k], world.grains.mass[k], world.grains.inertia[k]};
        };
        return pair_frequency(world.material, world.material.shear_ratio, of(g), of(5));
    };
    const double most = rolling_on_the_largest(4);
    for (std::size_t g = 0; g < 4; ++g) {
        EXPECT_LE(rolling_on_the_largest(g), most * 1.2) << g; // masses are lent by powers of two below
        EXPECT_GE(rolling_on_the_largest(g), most / 2)
            << g; // and moments by powers of two above: each up to a root of 2
    }
}

TEST(LentInertia, MakesNoGrainAsHeavyAsALargerOneNorChangesTheLargeOnes) {
    const World own = graded();
    World world = own;
    lend_inertia(world, median, {}, {true, true});
    for (std::size_t g = 1; g < own.grains.size(); ++g) {
        EXPECT_LT(world.grains.mass[g - 1], world.grains.mass[g]);
    }
    EXPECT_EQ(world.grains.mass[4], own.grains.mass[4]);
    EXPECT_EQ(world.grains.mass[5], own.grains.mass[5]);
    EXPECT_EQ(world.grains.inertia[5], 4 * own.grains.inertia[5]);
}

TEST(LentInertia, OfFinesAloneLetsThemRollBetweenTwoOfTheLargestNoQuickerThanOnTheirLike) {
    for (const Lent& lent :
         {Lent{.fines_rotation = true}, Lent{.mass = true, .fines_rotation = true},
          Lent{.mass = true, .gently = true, .fines_rotation = true}}) {
        World world = graded();
        world.material.shear_ratio = 1e-9; // the rolling springs alone, as soft
        world.material.rolling_stiffness = 1e12;
        World plain = world;
        lend_inertia(world, median, {}, lent);
        lend_inertia(plain, median, {}, {.mass = lent.mass, .gently = lent.gently});
        for (std::size_t g = 0; g < 4; ++g) {
            const Inertia largest{world.grains.radius[5], world.grains.mass[5], 1.0}; // which stands
            const auto of = [](const World& w, std::size_t k) {
                return Inertia{w.grains.radius[k], w.grains.mass[k], w.grains.inertia[k]};
            };
            const double ratio = world.material.shear_ratio;
            const double between_two = std::sqrt(2.0) * pair_frequency(world.material, ratio, of(world, g), largest);
            const double on_like = pair_frequency(world.material, ratio, of(plain, g), of(plain, g));
            EXPECT_LE(between_two, on_like * (1 + 1e-6)) << g;
            EXPECT_GE(between_two, on_like / std::sqrt(2.0) * (1 - 1e-6)) << g; // the power of two above
        }
        EXPECT_EQ(world.grains.inertia[4], plain.grains.inertia[4]);
        EXPECT_EQ(world.grains.inertia[5], plain.grains.inertia[5]);
    }
}

TEST(LentInertia, LentGentlyIsMassByTheRatioOfTheSizes) {
    const World own = graded();
    World world = own;
    lend_inertia(world, median, {}, {.mass = true, .gently = true});
    for (std::size_t g = 0; g < 6; ++g) {
        const double desired = std::max(1.0, median / 2 / own.grains.radius[g]);
        EXPECT_LE(std::abs(std::log2(world.grains.mass[g] / own.grains.mass[g] / desired)), 0.5) << g;
        EXPECT_EQ(world.grains.inertia[g] / own.grains.inertia[g], world.grains.mass[g] / own.grains.mass[g]);
    }
}

TEST(LentInertia, IsGivenBackToTheBitWhateverWasLentInBetween) {
    const World own = graded();
    World world = own;
    lend_inertia(world, median, {}, {true, true});
    lend_inertia(world, median, {true, true}, {true, false});
    lend_inertia(world, median, {true, false}, {false, true});
    const Lent wide{.mass = true, .gently = true, .fines_rotation = true};
    lend_inertia(world, median, {false, true}, wide);
    lend_inertia(world, median, wide, {.fines_rotation = true});
    lend_inertia(world, median, {.fines_rotation = true}, {});
    EXPECT_EQ(world.grains.mass, own.grains.mass);
    EXPECT_EQ(world.grains.inertia, own.grains.inertia);
}

} // namespace
} // namespace suffuse::dem
