#pragma once
// Clouds for the tests of compaction: grains of a sand of 0.15 to 0.30 mm that do not touch yet.

#include "suffuse/dem/world.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/packing/seed.hpp"

namespace suffuse::test {

inline dem::World sand_cloud(int particles) {
    grains::Soil soil;
    soil.whole = grains::Grading{{0.15e-3, 0.21e-3, 0.30e-3}, {0, 0.5, 1}, "three points"};
    soil.grading_tolerance = 0.1;
    const packing::Cloud made = packing::make_cloud(grains::sample_soil(soil, particles), packing::PackSpec{}, 2600, 5);
    dem::World world;
    world.cell = made.cell;
    world.reference_h = made.cell.h;
    world.grains = made.grains;
    return world;
}

} // namespace suffuse::test
