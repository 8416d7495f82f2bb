#include "suffuse/pores/triangulation_check.hpp"

#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 4096;

/// An edge seen from one of its grains, to sort by: the other grain, and where.
using EdgeEnd = std::pair<std::uint64_t, std::uint16_t>;

EdgeEnd edge_end(std::uint32_t other, const cell::Image& image) {
    const auto bits = [](std::int16_t period) { return static_cast<std::uint16_t>(period); };
    return {std::uint64_t{other} << 32 | std::uint64_t{bits(image.a)} << 16 | bits(image.b), bits(image.c)};
}

/// Appends the edges of tetrahedron `p` from corner `i` to grains of higher rows.
void add_edges(const Triangulation& t, std::size_t p, std::size_t i, std::vector<EdgeEnd>& ends) {
    const std::uint32_t from = t.grain[p][i];
    for (std::size_t j = 0; j < 4; ++j) {
        const std::uint32_t other = t.grain[p][j];
        const cell::Image image = t.grain_image[p][j] - t.grain_image[p][i];
        if (other > from) {
            ends.push_back(edge_end(other, image));
        } else if (other == from && i < j) {
            // A grain joined to its own image is seen from both ends: one of the two is taken.
            ends.push_back(edge_end(other, std::max(image, -image)));
        }
    }
}

/// Number of different edges on the torus. `corners`: rows 4 p + k of each grain.
std::size_t count_edges(const Triangulation& t, const Members& corners) {
    constexpr std::size_t grains_of_a_block = 256;
    const std::size_t grains = corners.first.size() - 1;
    return parallel_sum(grains, grains_of_a_block, std::size_t{0}, [&](std::size_t begin, std::size_t stop) {
        std::size_t count = 0;
        std::vector<EdgeEnd> ends;
        for (std::size_t g = begin; g < stop; ++g) {
            ends.clear();
            for (const std::uint32_t corner : corners.of(g)) {
                add_edges(t, corner / 4, corner % 4, ends);
            }
            std::sort(ends.begin(), ends.end());
            count += static_cast<std::size_t>(std::unique(ends.begin(), ends.end()) - ends.begin());
        }
        return count;
    });
}

std::size_t count_vertices(const Members& corners) {
    std::size_t count = 0;
    for (std::size_t g = 0; g + 1 < corners.first.size(); ++g) {
        count += corners.of(g).empty() ? 0 : 1;
    }
    return count;
}

} // namespace

std::optional<std::string> find_defect(const Triangulation& t, const Mat3& h, std::span<const Vec3> position) {
    const double total = parallel_sum(t.size(), block, 0.0, [&](std::size_t begin, std::size_t end) {
        double sum = 0;
        for (std::size_t p = begin; p < end; ++p) {
            const auto x = corners_of(t, p, h, position);
            sum += tetrahedron_volume(x[0], x[1], x[2], x[3]);
        }
        return sum;
    });
    const double cell_volume = determinant(h);
    if (!(std::abs(total - cell_volume) <= 1e-10 * cell_volume)) {
        return fmt::format(
            "the volumes of its {} tetrahedra add up to {:.15g} m3, the cell has {:.15g} m3", t.size(), total,
            cell_volume
        );
    }
    const std::size_t one_sided =
        parallel_sum(t.size(), block, std::size_t{0}, [&](std::size_t begin, std::size_t end) {
            std::size_t count = 0;
            for (std::size_t p = begin; p < end; ++p) {
                for (std::size_t k = 0; k < 4; ++k) {
                    count += facet_from_other_side(t, p, k) == 4 ? 1 : 0;
                }
            }
            return count;
        });
    if (one_sided != 0) {
        return fmt::format("{} of the {} sides of its facets have no other side", one_sided, 4 * t.size());
    }
    const Members corners =
        members_of(4 * t.size(), position.size(), [&](std::size_t c) { return t.grain[c / 4][c % 4]; });
    const std::size_t vertices = count_vertices(corners), edges = count_edges(t, corners);
    if (vertices + 2 * t.size() != edges + t.size()) { // F = 2 C, as each facet has two sides
        return fmt::format(
            "{} vertices, {} edges, {} facets and {} tetrahedra do not have the Euler characteristic 0 of a periodic "
            "cell",
            vertices, edges, 2 * t.size(), t.size()
        );
    }
    return std::nullopt;
}

} // namespace suffuse::pores
