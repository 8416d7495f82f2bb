#include "suffuse/plan/bench_packing.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/packing_checks.hpp"

#include <fmt/format.h>

namespace suffuse::plan {
namespace {

constexpr int most_copies = 30; // along an axis

} // namespace

dem::World load_bench_packing(const BenchPacking& packing) {
    if (packing.replicate < 1 || packing.replicate > most_copies) {
        throw CaseError(
            fmt::format("cannot repeat a packing {} times along each axis: 1 to {}", packing.replicate, most_copies)
        );
    }
    dem::World world;
    io::PackingRequest request{.file = packing.file, .density = world.material.density};
    if (!(packing.cell == Mat3{})) {
        request.cell = packing.cell;
    }
    const io::TakenPacking read = io::take_packing(request);
    if (!read.h) {
        throw CaseError(read.no_cell + "; give --cell LX,LY,LZ");
    }
    const Mat3& h = *read.h;
    const int n = packing.replicate;
    world.cell.h = static_cast<double>(n) * h;
    world.reference_h = world.cell.h;
    for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) {
            for (int c = 0; c < n; ++c) {
                const Vec3 shift = cell::shift(h, {a, b, c});
                for (std::size_t g = 0; g < read.grains.size(); ++g) {
                    add_grain(
                        world.grains, read.grains.position[g] + shift, read.grains.radius[g], world.material.density
                    );
                }
            }
        }
    }
    return world;
}

} // namespace suffuse::plan
