#include "suffuse/plan/priced_sample.hpp"

#include "suffuse/dem/stable_dt.hpp"

#include <gtest/gtest.h>

namespace suffuse::plan {
namespace {

/// Coarse grains, and fine ones of a size.
PricedSample two_sizes(int coarse, double large, int fine, double small) {
    grains::Grains grains;
    for (int g = 0; g < coarse + fine; ++g) {
        const bool is_fine = g >= coarse;
        const auto row = add_grain(grains, {}, is_fine ? small : large, 2600);
        grains.fine[row] = is_fine ? 1 : 0;
    }
    return describe(grains);
}

TEST(PricedSample, KnowsItsFractions) {
    const PricedSample sample = two_sizes(10, 2e-4, 80, 1e-4); // eight fines weigh as much as one coarse grain
    EXPECT_EQ(count(sample), 90);
    EXPECT_NEAR(fines_content(sample), 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(smallest_diameter(sample), 2e-4);
    EXPECT_DOUBLE_EQ(sample.coarse.median, 4e-4);
}

TEST(PricedSample, ATouchingPairOfItsGrainsSetsTheLooseTimeStep) {
    // The step's own bound for grains that do not touch.
    const grains::Material material;
    dem::World apart;
    apart.material = material;
    apart.cell.h = identity();
    add_grain(apart.grains, {}, 1e-4, material.density);
    add_grain(apart.grains, {0.5, 0.5, 0.5}, 2e-4, material.density);
    EXPECT_NEAR(loose_time_step(two_sizes(10, 2e-4, 80, 1e-4), material), dem::stable_time_step(apart), 1e-15);
}

TEST(PricedSample, LargeNeighborsShortenTheSettledTimeStep) {
    const grains::Material material;
    PricedSample equal = two_sizes(0, 0, 80, 1e-4), mixed = two_sizes(10, 3.5e-4, 80, 1e-4);
    take_state(equal, packing::equal_grains(0, false));
    take_state(mixed, packing::equal_grains(0, false));
    EXPECT_LT(settled_time_step(mixed, material), 0.8 * settled_time_step(equal, material));
    EXPECT_LE(settled_time_step(equal, material), loose_time_step(equal, material));
}

TEST(PricedSample, GrainsThatAreLentMassStepAsTheMedianGrain) {
    const grains::Material material;
    PricedSample mixed = two_sizes(100, 3.5e-4, 80, 1e-4), coarse = two_sizes(100, 3.5e-4, 0, 0);
    take_state(mixed, packing::equal_grains(0, true));
    take_state(coarse, packing::equal_grains(0, true));
    // A pair of fine grains is then as quick as one of coarse ones; what is left is how fine grains turn on coarse
    // ones.
    const double own = settled_time_step(mixed, material), lent = settled_time_step(mixed, material, {.mass = true});
    EXPECT_GT(lent, 2 * own);
    EXPECT_LE(lent, settled_time_step(coarse, material));
    EXPECT_DOUBLE_EQ(settled_time_step(coarse, material, {.mass = true}), settled_time_step(coarse, material));
}

TEST(PricedSample, FinesInTheVoidsAddAlmostNoWork) {
    // 10 % of fines by mass: they rattle between the coarse grains. 60 %: they carry.
    const auto work_of_fine = [](int fine) {
        PricedSample with = two_sizes(100, 3.5e-4, fine, 1e-4), without = two_sizes(100, 3.5e-4, 0, 1e-4);
        take_state(with, packing::equal_grains(0, true));
        take_state(without, packing::equal_grains(0, true));
        return (work_of_step(with).most - work_of_step(without).most) / fine;
    };
    EXPECT_LT(work_of_fine(476), 0.6 * work_of_fine(6431));
}

TEST(PricedSample, WithoutItsFinesTheCoarsePartIsLeft) {
    PricedSample sample = two_sizes(100, 3.5e-4, 476, 1e-4);
    take_state(sample, packing::equal_grains(0, true));
    take_fines(sample);
    EXPECT_EQ(count(sample), 100);
    EXPECT_EQ(fines_content(sample), 0);
    EXPECT_DOUBLE_EQ(smallest_diameter(sample), 7e-4);
    EXPECT_DOUBLE_EQ(sample.median, 7e-4);
}

TEST(PricedSample, ContactsThatOnlyPushAreLessWork) {
    PricedSample sample = two_sizes(100, 3.5e-4, 0, 1e-4);
    take_state(sample, packing::equal_grains(0, true));
    const double work = work_of_step(sample).most, pushing = work_of_step(sample, true).most;
    EXPECT_GT(pushing, 0.56 * work) << "the grains' own work is as before";
    EXPECT_LT(pushing, 0.75 * work);
}

TEST(PricedSample, AnErosionLeavesLessWork) {
    PricedSample sample = two_sizes(100, 3.5e-4, 1000, 1e-4);
    take_state(sample, packing::equal_grains(0, false));
    const double before = work_of_step(sample).most;
    sample.fines_left = {0.5, 0.5};
    EXPECT_LT(work_of_step(sample).most, before);
}

TEST(PricedSample, MixesToTheSpecifiedDensity) {
    PricedSample sample = two_sizes(100, 3.5e-4, 1000, 1e-4);
    const packing::EqualGrains state = state_at(sample, 0.66);
    EXPECT_NEAR(mixed_solid_fraction(sample, state.solid_fraction), 0.66, 1e-3);
}

} // namespace
} // namespace suffuse::plan
