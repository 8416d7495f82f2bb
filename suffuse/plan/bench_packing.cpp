#include "suffuse/plan/bench_packing.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/seed.hpp"

#include <fmt/format.h>

#include <utility>

namespace suffuse::plan {
namespace {

constexpr int most_copies = 30; // along an axis

/// The sand of the example, pushed together and pressed at 100 kPa, to a void ratio near 0.7.
dem::World make_packing() {
    constexpr int particles = 10'000;
    constexpr double millimeter = 1e-3, pressure = 100e3, from_porosity = 0.41; // to which it is pushed together
    grains::Soil soil;
    soil.whole = grains::Grading{
        .diameter = {0.10, 0.15, 0.18, 0.21, 0.25, 0.30, 0.40}, .passing = {0, 0.08, 0.25, 0.50, 0.75, 0.92, 1}};
    for (double& diameter : soil.whole->diameter) {
        diameter *= millimeter;
    }
    dem::World world;
    packing::Cloud cloud =
        packing::make_cloud(grains::sample_soil(soil, particles), {}, world.material.density, world.seed);
    world.cell = cloud.cell;
    world.reference_h = cloud.cell.h;
    world.grains = std::move(cloud.grains);
    const packing::CompactSpec spec{
        .pressure = pressure, .protocol = packing::Protocol::Swift, .start_porosity = from_porosity};
    packing::CompactState state = packing::begin_compaction(world, spec, dem::usual_damping);
    dem::StepCaches caches;
    while (!packing::compact_burst(world, caches, spec, {}, state)) {
    }
    return world;
}

dem::World read_packing(const BenchPacking& packing) {
    dem::World world;
    io::PackingRequest request{.file = packing.file, .density = world.material.density};
    if (!(packing.cell == Mat3{})) {
        request.cell = packing.cell;
    }
    io::TakenPacking read = io::take_packing(request);
    if (!read.h) {
        throw CaseError(read.no_cell + "; give --cell LX,LY,LZ");
    }
    world.cell.h = *read.h;
    world.grains = std::move(read.grains);
    return world;
}

} // namespace

dem::World load_bench_packing(const BenchPacking& packing) {
    if (packing.replicate < 1 || packing.replicate > most_copies) {
        throw CaseError(
            fmt::format("cannot repeat a packing {} times along each axis: 1 to {}", packing.replicate, most_copies)
        );
    }
    const dem::World one = packing.file.empty() ? make_packing() : read_packing(packing);
    const Mat3& h = one.cell.h;
    const int n = packing.replicate;
    dem::World world;
    world.cell.h = static_cast<double>(n) * h;
    world.reference_h = world.cell.h;
    for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) {
            for (int c = 0; c < n; ++c) {
                const Vec3 shift = cell::shift(h, {a, b, c});
                for (std::size_t g = 0; g < one.grains.size(); ++g) {
                    add_grain(
                        world.grains, one.grains.position[g] + shift, one.grains.radius[g], world.material.density
                    );
                }
            }
        }
    }
    return world;
}

} // namespace suffuse::plan
