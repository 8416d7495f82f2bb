#include "suffuse/pores/lattice.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/cell/cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 4096; // grains of a loop of a thread

constexpr double smallest_cell = 1e-30, largest_cell = 1e30; // [m]: their fourth powers are numbers

/// Of the shortest period: the sum of the forces on smaller grains is lost in rounding.
constexpr double smallest_grain = 1e-9;

constexpr int grid_bits = 44; // leaves 8 bits of a double for coordinates of up to 256 cell sizes: ghosts stay exact

double on_grid(double x) {
    return std::ldexp(std::nearbyint(std::ldexp(x, grid_bits)), -grid_bits);
}

Vec3 on_grid(const Vec3& x) {
    return {on_grid(x.x), on_grid(x.y), on_grid(x.z)};
}

Mat3 on_grid(const Mat3& h) {
    return from_columns(on_grid(h.column(0)), on_grid(h.column(1)), on_grid(h.column(2)));
}

/// Adds `times` of column `from` to column `to`.
void add_column(CompactBasis& basis, std::size_t to, std::size_t from, int times) {
    for (std::size_t row = 0; row < 3; ++row) {
        basis.h.m[row][to] += times * basis.h.m[row][from];
        basis.change[row][to] += times * basis.change[row][from];
    }
}

/// Shortens column `k` by the combination of the other two with factors -1, 0, 1 that helps most.
bool shorten(CompactBasis& basis, int k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Vec3 v = basis.h.column(k);
    double best = norm2(v) * (1 - 1e-12); // ties must not cycle
    int best_i = 0, best_j = 0;
    for (int m = -1; m <= 1; ++m) {
        for (int n = -1; n <= 1; ++n) {
            const double length = norm2(v + m * basis.h.column(i) + n * basis.h.column(j));
            if (length < best) {
                best = length, best_i = m, best_j = n;
            }
        }
    }
    if (best_i == 0 && best_j == 0) {
        return false;
    }
    add_column(basis, static_cast<std::size_t>(k), static_cast<std::size_t>(i), best_i);
    add_column(basis, static_cast<std::size_t>(k), static_cast<std::size_t>(j), best_j);
    return true;
}

/// A number in [-1, 1) that depends on the row and the axis only (splitmix64).
double scatter(std::uint64_t row, std::uint64_t axis) {
    std::uint64_t z = 0x9E3779B97F4A7C15ULL * (3 * row + axis + 1);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11), -52) - 1;
}

void check_cell(const Mat3& h) {
    const double size = std::max({norm(h.column(0)), norm(h.column(1)), norm(h.column(2))});
    const double v = determinant(h);
    if (!std::isfinite(v) || !(v > 1e-9 * size * size * size)) {
        throw GeometryError(fmt::format(
            "pores: the cell has volume {} m3 at a longest edge of {} m; its three vectors must be finite, "
            "right-handed and not (nearly) in one plane",
            v, size
        ));
    }
    if (!(size > smallest_cell && size < largest_cell)) {
        throw GeometryError(fmt::format(
            "pores: the cell's longest edge is {} m; volumes, conductances and forces need one between {} and {} m: "
            "give lengths in meters",
            size, smallest_cell, largest_cell
        ));
    }
}

void check_grains(const Mat3& compact, std::span<const Vec3> position, std::span<const double> radius) {
    if (radius.empty()) {
        throw GeometryError("pores: no grains in the cell; at least one is needed");
    }
    for (std::size_t g = 0; g < radius.size(); ++g) {
        const Vec3& x = position[g];
        if (!std::isfinite(norm2(x)) || !std::isfinite(radius[g]) || !(radius[g] > 0)) {
            throw GeometryError(fmt::format(
                "pores: grain in row {} has position ({}, {}, {}) m and radius {} m; finite numbers and a positive "
                "radius are needed",
                g, x.x, x.y, x.z, radius[g]
            ));
        }
    }
    const auto largest = std::max_element(radius.begin(), radius.end());
    const double period = std::min({norm(compact.column(0)), norm(compact.column(1)), norm(compact.column(2))});
    if (2 * *largest > 1.25 * period) { // contacts with the grain's own image overlap by a few percent, no more
        throw GeometryError(fmt::format(
            "pores: grain in row {} has diameter {} m and the cell repeats every {} m: it would overlap its own image; "
            "use a larger cell",
            largest - radius.begin(), 2 * *largest, period
        ));
    }
    const auto smallest = std::min_element(radius.begin(), radius.end());
    if (!(*smallest > smallest_grain * period)) {
        throw GeometryError(fmt::format(
            "pores: grain in row {} has radius {} m and the cell repeats every {} m: it is too small to be "
            "distinguished from a point; give grains and cell in one unit, or leave the grain out",
            smallest - radius.begin(), *smallest, period
        ));
    }
}

} // namespace

CompactBasis compact_basis(const Mat3& h) {
    CompactBasis basis{h, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    // Large shears take one step a period; each step shortens a vector, so this ends.
    while (shorten(basis, 0) || shorten(basis, 1) || shorten(basis, 2)) {
    }
    return basis;
}

ExactPacking
exact_packing(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, double jitter) {
    expects(position.size() == radius.size(), "one position and one radius a grain");
    check_cell(h);
    ExactPacking packing;
    packing.basis = compact_basis(h);
    const Mat3& compact = packing.basis.h;
    check_grains(compact, position, radius);

    const double size = std::max({norm(compact.column(0)), norm(compact.column(1)), norm(compact.column(2))});
    packing.unit = std::ldexp(1.0, std::ilogb(size));
    packing.h = on_grid((1 / packing.unit) * compact);
    packing.inverse_h = inverse(packing.h);
    packing.width = cell::widths(packing.h);
    packing.spacing = std::cbrt(determinant(packing.h) / static_cast<double>(radius.size()));

    const Mat3 inverse_compact = inverse(compact);
    const std::size_t count = radius.size();
    const std::size_t astray = parallel_sum(
        count, block, count,
        [&](std::size_t begin, std::size_t end) {
            while (begin < end && cell::has_period(inverse_compact, position[begin])) {
                ++begin;
            }
            return begin < end ? begin : count;
        },
        [](std::size_t one, std::size_t other) { return std::min(one, other); }
    );
    if (astray < count) {
        throw GeometryError(fmt::format(
            "pores: grain in row {} lies more than {} periods from the origin; wrap the positions into the cell",
            astray, cell::largest_period
        ));
    }
    resize_columns(count, packing.position, packing.radius, packing.period);
    parallel_for(count, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            const cell::Image period = cell::period_of(inverse_compact, position[g]);
            const Vec3 home = (1 / packing.unit) * (position[g] - cell::shift(compact, period));
            const Vec3 shake = jitter * packing.spacing * Vec3{scatter(g, 0), scatter(g, 1), scatter(g, 2)};
            packing.position[g] = on_grid(home + shake);
            packing.radius[g] = radius[g] / packing.unit;
            packing.period[g] = period;
        }
    });
    return packing;
}

} // namespace suffuse::pores
