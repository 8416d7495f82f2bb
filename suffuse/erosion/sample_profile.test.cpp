// Profiles of lattices, whose porosity and permeability are known.

#include "suffuse/erosion/sample_profile.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace suffuse::erosion {
namespace {

constexpr double D = 1e-3;    // of coarse grains [m]
constexpr double gap = 1.001; // between centers, over the diameter
const Vec3 upward = {0, 0, 1};

/// Cubic lattices on a square of 2 D: `coarse` layers of grains of D, above them `small` layers of grains of D/4.
dem::World layers_of_lattices(int coarse, int small) {
    dem::World world;
    const double thick = gap * D * coarse, d = D / 4;
    world.cell.h = diagonal({2 * gap * D, 2 * gap * D, thick + gap * d * small});
    const auto add = [&](double diameter, int across, int layers, double from, std::uint8_t fine) {
        for (int k = 0; k < across * across * layers; ++k) {
            const Vec3 corner{
                static_cast<double>(k % across), static_cast<double>(k / across % across),
                static_cast<double>(k / across / across)};
            const Vec3 at = gap * diameter * (corner + Vec3{0.5, 0.5, 0.5}) + Vec3{0, 0, from};
            world.grains.fine[add_grain(world.grains, at, diameter / 2, world.material.density)] = fine;
        }
    };
    add(D, 2, coarse, 0, 0);
    add(d, 8, small, thick, 1);
    return world;
}

flow::Seepage flow_through(const dem::World& world) {
    return flow::solve_seepage(
        world.cell, world.grains.position, world.grains.radius, {.gradient = 1, .direction = upward}, {}
    );
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(SampleProfile, OfALatticeHasTheSolidOfCapsAndTheSamePermeabilityInEachPeriod) {
    const dem::World world = layers_of_lattices(4, 0);
    SampleProfile profile = begin_sample_profile(world, upward);
    EXPECT_EQ(profile.slices, 8U) << "half a grain each";
    profile.slices = 16;
    const flow::Seepage seepage = flow_through(world);
    note_sample_profile(world, seepage, upward, profile);
    ASSERT_EQ(profile.porosity.size(), 1U);
    // A quarter of a period at its edge: a cap of height h = D/4 less half of the gap, of a sphere.
    const double step = gap * D / 4, h = step - 0.5 * (gap - 1) * D;
    const double cap = pi * h * h * (1.5 * D - h) / 3, square = gap * gap * D * D;
    EXPECT_NEAR(profile.porosity.front()[0], 1 - cap / (square * step), 1e-12);
    EXPECT_NEAR(profile.porosity.front()[1], 1 - (pi / 12 * D * D * D - cap) / (square * step), 1e-12);
    EXPECT_NEAR(mean_of(profile.porosity.front()), dem::porosity(world), 1e-12);
    EXPECT_NEAR(mean_of(profile.fines.front()), 0, 0);
    const std::vector<double>& k = profile.permeability.front();
    for (std::size_t slice = 0; slice < k.size(); ++slice) {
        EXPECT_NEAR(k[slice] / k[slice % 4], 1, 1e-6);
    }
    const std::vector<double> heads = head_shares(seepage, upward, 4 * gap * D, 5);
    EXPECT_NEAR(std::accumulate(heads.begin(), heads.end(), 0.0), 1, 1e-12);
}

TEST(SampleProfile, OfLayersHasTheirOwnPermeabilities) {
    const dem::World world = layers_of_lattices(6, 16);
    SampleProfile profile = begin_sample_profile(world, upward);
    profile.slices = 40; // four to a coarse grain, one to a layer of small ones
    note_sample_profile(world, flow_through(world), upward, profile);
    const double coarse = flow_through(layers_of_lattices(6, 0)).permeability;
    const dem::World small = layers_of_lattices(0, 16);
    const double fine = flow_through(small).permeability;
    const auto mean_resistance = [&](std::size_t from, std::size_t to) { // whole periods, away from the planes between
        double sum = 0;
        for (std::size_t k = from; k < to; ++k) {
            sum += 1 / profile.permeability.front()[k];
        }
        return sum / static_cast<double>(to - from);
    };
    EXPECT_NEAR(mean_resistance(4, 20) * coarse, 1, 0.02);
    EXPECT_NEAR(mean_resistance(28, 36) * fine, 1, 0.02);
    EXPECT_NEAR(mean_resistance(0, 40) * flow_through(world).permeability, 1, 1e-9) << "heads add up";
    EXPECT_NEAR(profile.fines.front()[10], 0, 1e-15);
    EXPECT_NEAR(profile.fines.front()[30], 1 - dem::porosity(small), 1e-9);
}

TEST(SampleProfile, NeedsPlanesOfTheCellAcrossTheFlow) {
    const dem::World world = layers_of_lattices(4, 0);
    EXPECT_EQ(begin_sample_profile(world, {0, 0, -2}).slices, 8U);
    EXPECT_EQ(begin_sample_profile(world, {0, 0.1, 1}).slices, 0U);
}

} // namespace
} // namespace suffuse::erosion
