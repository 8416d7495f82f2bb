#pragma once
// Clouds for the tests of compaction: grains that do not touch yet, of a sand of 0.15 to 0.30 mm or of a specified
// width.

#include "suffuse/dem/world.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/packing/seed.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::test {

inline dem::World cloud_of(const grains::SampledGrains& grains) {
    const packing::Cloud made = packing::make_cloud(grains, packing::PackSpec{}, 2600, 5);
    dem::World world;
    world.cell = made.cell;
    world.reference_h = made.cell.h;
    world.grains = made.grains;
    return world;
}

inline dem::World sand_cloud(int particles) {
    grains::Soil soil;
    soil.whole = grains::Grading{{0.15e-3, 0.21e-3, 0.30e-3}, {0, 0.5, 1}, "three points"};
    soil.grading_tolerance = 0.1;
    return cloud_of(grains::sample_soil(soil, particles));
}

/// Diameters from 0.1 mm to so many times that, as much mass in each equal step of diameter.
inline dem::World cloud_of_ratio(double ratio, int particles) {
    grains::SampledGrains grains;
    for (int g = 0; g < particles; ++g) {
        const double share = (g + 0.5) / particles;
        grains.radius.push_back(0.5e-4 * std::pow(1 - share * (1 - std::pow(ratio, -3)), -1.0 / 3));
    }
    std::ranges::reverse(grains.radius);
    grains.fine.assign(grains.radius.size(), 0);
    return cloud_of(grains);
}

} // namespace suffuse::test
