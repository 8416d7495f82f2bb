#include "suffuse/grains/modeled_part.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace suffuse::grains {
namespace {

/// A sand without the sizes from 0.3 to 1 mm, 20 % of it finer.
const Grading gap_graded{{0.15e-3, 0.3e-3, 1e-3, 2e-3}, {0, 0.2, 0.2, 1}, "gap"};

/// Five decades of sizes.
const Grading moraine{{0.002e-3, 0.063e-3, 1e-3, 200e-3}, {0, 0.1, 0.3, 1}, "moraine"};

TEST(ModeledPart, TheCountIsWhatASampleOfThatSizeHas) {
    const double count = representative_count(gap_graded, 0.5e-3);
    Soil soil;
    soil.whole = gap_graded;
    soil.finer_than = 0.5e-3;
    const SampledGrains sample = sample_soil(soil, static_cast<int>(std::ceil(count)));
    const auto coarse = std::count(sample.fine.begin(), sample.fine.end(), std::uint8_t{0});
    EXPECT_GE(coarse, 99); // 100, but for the grain that the sampling rounds to either side
    double solid = 0;
    for (const double r : sample.radius) {
        solid += 4.0 / 3.0 * 3.14159265358979 * r * r * r;
    }
    // The cell, in diameters of the largest grain; the drawn one is a little smaller.
    EXPECT_GE(std::cbrt(solid / 0.6) / 2e-3, 3.95);
    EXPECT_LE(sample.largest_difference, 0.02);
    Representative wide;
    wide.cell_width = 10;
    EXPECT_GT(representative_count(gap_graded, 0.5e-3, wide), 5 * count);
}

TEST(ModeledPart, AUniformSkeletonIsAsWideAsErosionNeeds) {
    const Grading uniform{{0.1e-3, 0.2e-3, 1e-3, 1.1e-3}, {0, 0.2, 0.2, 1}, "uniform"};
    Representative narrow;
    narrow.skeleton_width = 0;
    const double count = representative_count(uniform, 0.5e-3), less = representative_count(uniform, 0.5e-3, narrow);
    EXPECT_GT(count, 1.5 * less); // four of the largest grains are 4.2 median ones; six are requested
    double solid = 0;
    const std::vector<double> drawn = sample_diameters(uniform, static_cast<std::size_t>(std::ceil(count)));
    for (const double d : drawn) {
        solid += sphere_volume(0.5 * d);
    }
    // By number the median of the coarse grains is 1.045 mm. The count is rounded up, and the median is one of a
    // hundred.
    EXPECT_NEAR(std::cbrt(solid / 0.6) / 1.045e-3, 6, 0.03);
}

TEST(ModeledPart, NothingIsCutWhereTheGrainsSuffice) {
    const auto part = find_modeled_part(gap_graded, {0.3e-3, 1e-3}, 1.01 * representative_count(gap_graded, 0.5e-3));
    ASSERT_TRUE(part);
    EXPECT_EQ(part->finest, 0.15e-3);
    EXPECT_EQ(part->coarsest, 2e-3);
    EXPECT_EQ(part->fines_kept, 1);
    EXPECT_EQ(part->coarse_kept, 1);
}

TEST(ModeledPart, AWideCurveIsCutToWhatSoManyGrainsStandFor) {
    const double split = 1e-3;
    const auto part = find_modeled_part(moraine, {split, split}, 10'000);
    ASSERT_TRUE(part);
    const Grading cut = part_between(moraine, part->finest, part->coarsest);
    EXPECT_LE(representative_count(cut, split), 10'000 * 1.1); // grains_needed() rounds up to two digits
    EXPECT_GE(part->fines_kept, 0.09);                         // a tenth, but for sizes of three digits
    EXPECT_GE(part->coarse_kept, 0.09);
    EXPECT_NEAR(part->fines_kept, 1 - passing(moraine, part->finest) / 0.3, 1e-12);
    // As little as can be: keeping a tenth more at both ends takes more grains.
    const double finer = size_at(moraine, 0.3 * std::max(0.0, 0.9 - part->fines_kept));
    const double coarser = size_at(moraine, std::min(1.0, 0.4 + 0.7 * part->coarse_kept));
    EXPECT_GT(representative_count(part_between(moraine, finer, coarser), split), 10'000);
}

TEST(ModeledPart, ACutKeepsGrainsBelowAndAboveAGapWhateverLiesInIt) {
    // A tenth of the mass lies in the gap from 0.25 to 2 mm: a cut within it would keep no skeleton.
    const Grading gravel{{0.05e-3, 0.25e-3, 2e-3, 8e-3}, {0, 0.2, 0.3, 1}, "gravel"};
    const auto part = find_modeled_part(gravel, {0.25e-3, 2e-3}, 200'000);
    ASSERT_TRUE(part);
    EXPECT_GT(part->coarsest, 2e-3);
    EXPECT_LT(part->finest, 0.25e-3);
    EXPECT_NEAR(part->coarse_kept, (passing(gravel, part->coarsest) - 0.3) / 0.7, 1e-12);
    EXPECT_FALSE(find_modeled_part(part_between(gravel, 0.05e-3, 1.9e-3), {0.25e-3, 2e-3}, 200'000));
}

TEST(ModeledPart, AGapThatIsTooWideCannotBeCutAway) {
    const Grading far_apart{{0.01e-3, 0.02e-3, 10e-3, 20e-3}, {0, 0.3, 0.3, 1}, "far"};
    EXPECT_FALSE(find_modeled_part(far_apart, {0.02e-3, 10e-3}, 10'000));
}

} // namespace
} // namespace suffuse::grains
