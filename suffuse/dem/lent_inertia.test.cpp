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

TEST(LentInertia, LetsTheTimeStepBeThatOfTheMedianGrainWithinItsPowerOfTwo) {
    World world = graded(), median_grain = test::empty_world(1e-2);
    test::add(median_grain, {}, median / 2);
    lend_inertia(world, median, {}, {true, false});
    const double longest = stable_time_step(median_grain);
    EXPECT_LE(stable_time_step(world), longest);
    EXPECT_GE(stable_time_step(world), longest / std::sqrt(2));
    EXPECT_LT(stable_time_step(graded()), 0.11 * longest);
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

TEST(LentInertia, IsGivenBackToTheBitWhateverWasLentInBetween) {
    const World own = graded();
    World world = own;
    lend_inertia(world, median, {}, {true, true});
    lend_inertia(world, median, {true, true}, {true, false});
    lend_inertia(world, median, {true, false}, {false, true});
    lend_inertia(world, median, {false, true}, {});
    EXPECT_EQ(world.grains.mass, own.grains.mass);
    EXPECT_EQ(world.grains.inertia, own.grains.inertia);
}

} // namespace
} // namespace suffuse::dem
