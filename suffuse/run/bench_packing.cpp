#include "suffuse/run/bench_packing.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/packing_file.hpp"

#include <fmt/format.h>

namespace suffuse::run {
namespace {

constexpr double most_overlap = 0.1; // of the smaller radius: beyond, it is another cell's packing
constexpr int most_copies = 30;      // along an axis

} // namespace

dem::World load_bench_packing(const BenchPacking& packing) {
    if (packing.replicate < 1 || packing.replicate > most_copies) {
        throw CaseError(
            fmt::format("cannot repeat a packing {} times along each axis: 1 to {}", packing.replicate, most_copies)
        );
    }
    dem::World world;
    const io::ImportedPacking read = io::read_packing(packing.file, world.material.density);
    const bool is_given = !(packing.cell == Mat3{});
    if (!is_given && !read.cell) {
        throw CaseError(fmt::format("{}: carries no cell; give --cell LX,LY,LZ", packing.file.string()));
    }
    const cell::Cell one{is_given ? packing.cell : read.cell->h, {}};
    io::check_overlaps(read.grains, one, most_overlap, packing.file.string());
    const int n = packing.replicate;
    world.cell.h = static_cast<double>(n) * one.h;
    world.reference_h = world.cell.h;
    for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) {
            for (int c = 0; c < n; ++c) {
                const Vec3 shift = cell::shift(one.h, {a, b, c});
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

} // namespace suffuse::run
