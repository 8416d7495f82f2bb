#include "suffuse/grains/sample_size.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/grains/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace suffuse::grains {
namespace {

/// Two fractions, each of nearly one size, whose sizes differ `ratio` times.
Soil two_sizes(double ratio, double fines_content) {
    const double d = 1e-3;
    Soil soil;
    soil.coarse = Grading{{0.9999 * d, 1.0001 * d}, {0, 1}, "coarse"};
    soil.fines = Grading{{0.9999 * d / ratio, 1.0001 * d / ratio}, {0, 1}, "fines"};
    soil.fines_content = fines_content;
    soil.grading_tolerance = 0.5;
    return soil;
}

TEST(SampleSize, CountsGrainsOfEqualSphereFractionsExactly) {
    // Equal masses, sizes 2:1: eight fines for each coarse grain. The widths of the fractions change this by 1e-8.
    const SampleSize size = size_sample(two_sizes(2, 0.5), {200, 100, 1});
    EXPECT_EQ(size.particles, 200 * 9);
    EXPECT_EQ(size.rule, SizedBy::CoarseGrains);
}

TEST(SampleSize, TheSampleHasTheSpecifiedCoarseGrains) {
    for (const double content : {0.05, 0.2, 0.4, 0.6, 0.8}) {
        const Soil soil = two_sizes(3.5, content);
        const SampleSize size = size_sample(soil, {200, 100, 1});
        const SampledGrains sample = sample_soil(soil, static_cast<int>(size.particles));
        EXPECT_EQ(std::count(sample.fine.begin(), sample.fine.end(), 0), 200) << content;
    }
}

TEST(SampleSize, ACellOfTenDiametersIsCheaperWhereFewGrainsAreCoarse) {
    // In a cell ten diameters wide at a porosity of 0.4 there is room for 600 d3/(pi d3/6) coarse grains.
    const double whole = 600 / (pi / 6);
    const double turns = 1 - 200 / whole; // above this fines content fewer than 200 are coarse
    EXPECT_EQ(size_sample(two_sizes(3.5, turns - 0.01), {}).rule, SizedBy::CoarseGrains);
    const SampleSize wide = size_sample(two_sizes(3.5, turns + 0.01), {});
    EXPECT_EQ(wide.rule, SizedBy::CellWidth);
    const double fines_share = turns + 0.01;
    EXPECT_NEAR(
        static_cast<double>(wide.particles), whole * (1 - fines_share + fines_share * std::pow(3.5, 3)), 1
    ); // rounding
}

TEST(SampleSize, AFloorHoldsWhereAFewGrainsWouldDo) {
    const SampleSize sand = size_sample(two_sizes(3.5, 0), {200, 10, 2000});
    EXPECT_EQ(sand.particles, 2000);
    EXPECT_EQ(sand.rule, SizedBy::AtLeast);
    EXPECT_EQ(size_sample(two_sizes(3.5, 0), {200, 10, 1}).particles, 200);
    EXPECT_EQ(size_sample(two_sizes(3.5, 1), {200, 10, 1}).particles, 200) << "fines alone are counted by themselves";
}

TEST(SampleSize, NeedsTwoFractions) {
    Soil one;
    one.whole = Grading{{1e-4, 2e-4}, {0, 1}, "sand"};
    EXPECT_THROW(size_sample(one, {}), CaseError);
}

TEST(SampleSize, ACeilingTakesCoarseGrainsAwayDownToTheLeastNumber) {
    SampleSizeSpec spec{200, 100, 1};
    const auto coarse_of = [](const Soil& soil, const SampleSize& size) {
        const SampledGrains sample = sample_soil(soil, static_cast<int>(size.particles));
        return std::count(sample.fine.begin(), sample.fine.end(), 0);
    };
    const Soil soil = two_sizes(2, 0.5); // nine grains for each coarse one
    spec.at_most = 900;
    const SampleSize paid = size_sample(soil, spec);
    EXPECT_EQ(paid.rule, SizedBy::AtMost);
    EXPECT_EQ(paid.particles, 900);
    EXPECT_EQ(coarse_of(soil, paid), 100);
    spec.at_most = 400;
    const SampleSize least = size_sample(soil, spec);
    EXPECT_EQ(least.rule, SizedBy::LeastCoarse);
    EXPECT_EQ(least.particles, 60 * 9);
    EXPECT_EQ(coarse_of(soil, least), 60);
    spec.at_most = 5000;
    EXPECT_EQ(size_sample(soil, spec).rule, SizedBy::CoarseGrains);
}

TEST(SampleSize, ASoilOfFinesAloneHasNoCoarseGrainsForACeilingToSpare) {
    SampleSizeSpec spec{2000, 100, 1};
    spec.at_most = 500;
    const SampleSize size = size_sample(two_sizes(3.5, 1), spec);
    EXPECT_EQ(size.rule, SizedBy::AtMost);
    EXPECT_EQ(size.particles, 500);
}

} // namespace
} // namespace suffuse::grains
