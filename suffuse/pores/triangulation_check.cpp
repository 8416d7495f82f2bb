#include "suffuse/pores/triangulation_check.hpp"

#include "suffuse/base/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 4096;

/// An edge seen from its grain of lower row: the other grain, and where.
struct EdgeEnd {
    std::uint32_t other;
    cell::Image image;

    auto operator<=>(const EdgeEnd&) const = default;
};

EdgeEnd edge_end(const Triangulation& t, std::size_t p, std::size_t i, std::size_t j) {
    return {t.grain[p][j], t.grain_image[p][j] - t.grain_image[p][i]};
}

template <class Visit>
void for_each_edge(const Triangulation& t, Visit&& visit) {
    for (std::size_t p = 0; p < t.size(); ++p) {
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = i + 1; j < 4; ++j) {
                const bool swapped = t.grain[p][j] < t.grain[p][i];
                EdgeEnd end = swapped ? edge_end(t, p, j, i) : edge_end(t, p, i, j);
                const std::uint32_t from = swapped ? t.grain[p][j] : t.grain[p][i];
                // A grain joined to its own image is seen from both ends: one of the two is taken.
                if (end.other == from && end.image < -end.image) {
                    end.image = -end.image;
                }
                visit(from, end);
            }
        }
    }
}

/// Number of different edges on the torus: the ends are sorted into one bucket a grain.
std::size_t count_edges(const Triangulation& t, std::size_t grains) {
    std::vector<std::uint32_t> first(grains + 1, 0);
    for_each_edge(t, [&](std::uint32_t g, const EdgeEnd&) { ++first[g + 1]; });
    for (std::size_t g = 0; g < grains; ++g) {
        first[g + 1] += first[g];
    }
    std::vector<EdgeEnd> ends(first[grains]);
    std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
    for_each_edge(t, [&](std::uint32_t g, const EdgeEnd& end) { ends[fill[g]++] = end; });
    return parallel_sum(grains, block, std::size_t{0}, [&](std::size_t begin, std::size_t stop) {
        std::size_t count = 0;
        for (std::size_t g = begin; g < stop; ++g) {
            const auto from = ends.begin() + first[g], to = ends.begin() + first[g + 1];
            std::sort(from, to);
            count += static_cast<std::size_t>(std::unique(from, to) - from);
        }
        return count;
    });
}

std::size_t count_vertices(const Triangulation& t, std::size_t grains) {
    std::vector<std::uint8_t> seen(grains, 0);
    for (const auto& corners : t.grain) {
        for (const std::uint32_t g : corners) {
            seen[g] = 1;
        }
    }
    return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), std::uint8_t{1}));
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
    const std::size_t vertices = count_vertices(t, position.size()), edges = count_edges(t, position.size());
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
