#include "suffuse/neighbors/grid.hpp"

#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace suffuse::neighbors {
namespace {

constexpr int most_classes = 32;
constexpr std::size_t block = 4096; // grains of one loop of a thread

/// Of a home position, which rounding may put on either face of the cell: kept on the side where it is, for the grid to
/// find it there.
double within_cell(double s) {
    return std::clamp(s, 0.0, 1.0 - std::numeric_limits<double>::epsilon() / 2);
}

Grid build_grid(
    const Vec3& width, const HomePositions& home, std::span<const double> radius,
    const std::vector<std::uint32_t>& members, double margin
) {
    Grid grid;
    for (const std::uint32_t g : members) {
        grid.largest_radius = std::max(grid.largest_radius, radius[g]);
    }
    // As fine as the grains allow, but never many more bins than grains: a few fines in a large cell stay cheap.
    const double size = 2 * grid.largest_radius + margin;
    const double most = std::cbrt(2.0 * static_cast<double>(members.size())) + 1;
    for (int a = 0; a < 3; ++a) {
        grid.bins.along[static_cast<std::size_t>(a)] = std::max(1, static_cast<int>(std::min(width[a] / size, most)));
    }
    Members by_bin = members_of(members.size(), grid.bins.count(), [&](std::size_t k) {
        return grid.bins.bin_of(home.fraction[members[k]]);
    });
    grid.start = std::move(by_bin.first);
    grid.grain = std::move(by_bin.row);
    parallel_for(grid.grain.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            grid.grain[k] = members[grid.grain[k]];
        }
    });
    return grid;
}

} // namespace

int size_class(double radius, double largest_radius) {
    return std::clamp(static_cast<int>(std::floor(std::log2(largest_radius / radius))), 0, most_classes - 1);
}

HomePositions bring_home(const Mat3& h, std::vector<Vec3> position) {
    const Mat3 inverse_h = inverse(h);
    const std::size_t grains = position.size();
    HomePositions home;
    home.fraction.resize(grains);
    home.position = std::move(position);
    home.period.resize(grains);
    parallel_for(grains, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            home.period[g] = cell::period_of(inverse_h, home.position[g]);
            home.position[g] = home.position[g] - cell::shift(h, home.period[g]);
            const Vec3 s = inverse_h * home.position[g];
            home.fraction[g] = {within_cell(s.x), within_cell(s.y), within_cell(s.z)};
        }
    });
    return home;
}

std::vector<Grid> build_grids(const Mat3& h, const HomePositions& home, std::span<const double> radius, double margin) {
    double largest = 0;
    for (const double r : radius) {
        largest = std::max(largest, r);
    }
    // Each block of grains lists its members of each class; a class takes those of all blocks, in their order.
    using Classes = std::array<std::vector<std::uint32_t>, most_classes>;
    std::vector<Classes> listed((radius.size() + block - 1) / block);
    parallel_for(radius.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            const auto c = static_cast<std::size_t>(size_class(radius[g], largest));
            listed[begin / block][c].push_back(static_cast<std::uint32_t>(g));
        }
    });
    Classes members;
    for (const Classes& classes : listed) {
        for (std::size_t c = 0; c < members.size(); ++c) {
            members[c].insert(members[c].end(), classes[c].begin(), classes[c].end());
        }
    }
    std::vector<Grid> grids(most_classes);
    const Vec3 width = cell::widths(h);
    for (std::size_t c = 0; c < members.size(); ++c) {
        if (!members[c].empty()) {
            grids[c] = build_grid(width, home, radius, members[c], margin);
        }
    }
    return grids;
}

} // namespace suffuse::neighbors
