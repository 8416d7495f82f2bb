#include "suffuse/pores/triangulation.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/members.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/raw_column.hpp"
#include "suffuse/pores/lattice.hpp"
#include "suffuse/pores/part_of_cell.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 1024;

/// Number of parts worth their images: two of 10,000 grains, which have a tenth more images than one; 16 of a million;
/// one a thread where each has grains enough to be worth twice the work. However it is cut, the triangulation is one.
int suitable_parts(std::size_t grains) {
    constexpr double grains_in_two = 10'000;
    constexpr std::size_t least_grains = 4'000;
    const int few = static_cast<int>(2 * std::sqrt(static_cast<double>(grains) / grains_in_two));
    const int most = static_cast<int>(grains / least_grains);
    return std::max(few, std::min(2 * thread_count() - 1, most));
}

/// Halves the widest side of the parts until there are enough of them.
Cuts choose_cuts(const ExactPacking& packing, int parts) {
    const int wanted = parts > 0 ? parts : suitable_parts(packing.radius.size());
    Cuts cuts = {1, 1, 1};
    while (2 * cuts[0] * cuts[1] * cuts[2] <= wanted) {
        std::size_t widest = 0;
        for (std::size_t a = 1; a < 3; ++a) {
            const auto side = [&](std::size_t k) { return packing.width[static_cast<int>(k)] / cuts[k]; };
            widest = side(a) > side(widest) ? a : widest;
        }
        cuts[widest] *= 2;
    }
    return cuts;
}

std::vector<PartTetrahedra> triangulate_parts(const ExactPacking& packing, const Cuts& cuts, Care care) {
    std::vector<PartTetrahedra> parts(static_cast<std::size_t>(cuts[0] * cuts[1] * cuts[2]));
    parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const int k = static_cast<int>(p);
            const Part part = {k % cuts[0], k / cuts[0] % cuts[1], k / (cuts[0] * cuts[1])};
            parts[p] = triangulate_part(packing, cuts, part, care);
        }
    });
    return parts;
}

/// A tetrahedron of a part, and where it stands among all.
struct Entry {
    std::uint64_t place;
    std::uint32_t part, row;
};

/// All tetrahedra along the curve that fills the cell, so that what is close in space is close in memory. Those of each
/// part are sorted, then neighboring runs are merged until one is left.
RawColumn<Entry> order_tetrahedra(const std::vector<PartTetrahedra>& parts) {
    std::vector<std::size_t> first = {0}; // of each run, and the end
    for (const PartTetrahedra& part : parts) {
        first.push_back(first.back() + part.corner.size());
    }
    RawColumn<Entry> order(first.back());
    const auto comes_before = [&](const Entry& one, const Entry& other) {
        return one.place != other.place ? one.place < other.place
                                        : parts[one.part].corner[one.row] < parts[other.part].corner[other.row];
    };
    const auto at = [&](std::size_t run) {
        return order.begin() + static_cast<std::ptrdiff_t>(first[std::min(run, parts.size())]);
    };
    parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t run = begin; run < end; ++run) {
            for (std::uint32_t row = 0; row < parts[run].corner.size(); ++row) {
                order[first[run] + row] = {parts[run].place[row], static_cast<std::uint32_t>(run), row};
            }
            std::sort(at(run), at(run + 1), comes_before);
        }
    });
    for (std::size_t width = 1; width < parts.size(); width *= 2) {
        parallel_for(parts.size(), 2 * width, [&](std::size_t begin, std::size_t) {
            std::inplace_merge(at(begin), at(begin + width), at(begin + 2 * width), comes_before);
        });
    }
    return order;
}

/// A facet of a tetrahedron whose other side lies in another part, or is an image of one that is kept. (That image as
/// triangulated here may be wrong: only kept tetrahedra are known to have all images around them.)
struct OpenFacet {
    Canonical<3> facet;
    std::uint32_t p, k;
};

/// Joins two sides of a facet; false where they are not of one.
bool join(const OpenFacet& one, const OpenFacet& other, const CompactBasis& basis, Triangulation& out) {
    if (one.facet.corners != other.facet.corners) {
        return false;
    }
    const cell::Image between = basis.original(one.facet.moved - other.facet.moved);
    out.neighbor[one.p][one.k] = other.p;
    out.neighbor_image[one.p][one.k] = between;
    out.neighbor[other.p][other.k] = one.p;
    out.neighbor_image[other.p][other.k] = -between;
    return true;
}

/// Joins the two sides of every open facet; false where there are not two.
bool close(const std::vector<OpenFacet>& open, const ExactPacking& packing, Triangulation& out) {
    const std::size_t grains = packing.radius.size();
    const Members facets =
        members_of(open.size(), grains, [&](std::size_t f) { return open[f].facet.corners[0].grain; });
    const std::size_t failed = parallel_sum(grains, block, std::size_t{0}, [&](std::size_t begin, std::size_t end) {
        std::size_t count = 0;
        std::vector<std::uint32_t> sides;
        for (std::size_t g = begin; g < end; ++g) {
            sides.assign(facets.of(g).begin(), facets.of(g).end());
            std::sort(sides.begin(), sides.end(), [&](std::uint32_t one, std::uint32_t other) {
                return open[one].facet.corners < open[other].facet.corners;
            });
            count += sides.size() % 2;
            for (std::size_t f = 0; f + 1 < sides.size(); f += 2) {
                count += join(open[sides[f]], open[sides[f + 1]], packing.basis, out) ? 0 : 1;
            }
        }
        return count;
    });
    return failed == 0;
}

/// Writes tetrahedron p; its facets whose other side is elsewhere are left open.
void write_tetrahedron(
    const ExactPacking& packing, const PartTetrahedra& part, std::uint32_t row, std::span<const std::uint32_t> number,
    std::uint32_t p, Triangulation& out, std::vector<OpenFacet>& open
) {
    const std::array<Corner, 4>& corner = part.corner[row];
    for (std::uint32_t k = 0; k < 4; ++k) {
        const Corner& c = corner[k];
        out.grain[p][k] = c.grain;
        out.grain_image[p][k] = packing.basis.original(c.image - packing.period[c.grain]);
        if (part.neighbor[row][k] != PartTetrahedra::none) {
            out.neighbor[p][k] = number[part.neighbor[row][k]];
            continue;
        }
        const auto facet = std::array{corner[(k + 1) % 4], corner[(k + 2) % 4], corner[(k + 3) % 4]};
        open.push_back({canonical(facet), p, k});
    }
}

/// Grains that are no corner.
std::vector<std::uint32_t> find_hidden(const Triangulation& triangulation, std::size_t grains) {
    std::vector<std::uint8_t> seen(grains, 0);
    parallel_for(triangulation.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            for (const std::uint32_t g : triangulation.grain[p]) {
                std::atomic_ref(seen[g]).store(1, std::memory_order_relaxed);
            }
        }
    });
    std::vector<std::uint32_t> hidden;
    for (std::uint32_t g = 0; g < grains; ++g) {
        if (seen[g] == 0) {
            hidden.push_back(g);
        }
    }
    return hidden;
}

/// The tetrahedra of all parts as one table; false where images of the cell, or two parts, are not triangulated alike.
bool join_parts(const ExactPacking& packing, const std::vector<PartTetrahedra>& parts, Triangulation& out) {
    const RawColumn<Entry> order = order_tetrahedra(parts);
    std::vector<RawColumn<std::uint32_t>> number;
    for (const PartTetrahedra& part : parts) {
        number.emplace_back(part.corner.size());
        out.ghosts += part.points;
        out.margin = std::max(out.margin, part.reach * packing.unit);
    }
    out.ghosts -= packing.radius.size();
    parallel_for(order.size(), block, [&](std::size_t begin, std::size_t end) {
        for (auto p = static_cast<std::uint32_t>(begin); p < end; ++p) {
            number[order[p].part][order[p].row] = p;
        }
    });
    resize_columns(order.size(), out.grain, out.grain_image, out.neighbor, out.neighbor_image);
    std::vector<std::vector<OpenFacet>> open_of_block((order.size() + block - 1) / block);
    parallel_for(order.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const auto [place, part, row] = order[p];
            write_tetrahedron(
                packing, parts[part], row, number[part], static_cast<std::uint32_t>(p), out,
                open_of_block[begin / block]
            );
        }
    });
    std::vector<OpenFacet> open;
    for (const std::vector<OpenFacet>& some : open_of_block) {
        open.insert(open.end(), some.begin(), some.end());
    }
    out.hidden = find_hidden(out, packing.radius.size());
    return close(open, packing, out);
}

} // namespace

Triangulation triangulate(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, int parts) {
    // Few images serve nearly all packings: should a tetrahedron be missing, more are taken. Exact predicates with a
    // translation-invariant tie rule serve lattices as they are. Should images of the cell be triangulated differently
    // after all, grains are moved by a trifle to decide the ties; geometry keeps the true ones.
    struct Attempt {
        double jitter;
        Care care;
    };

    std::string defect;
    for (const auto [jitter, care] :
         {Attempt{0, Care::Kept}, {0, Care::Whole}, {1e-9, Care::Whole}, {1e-7, Care::Whole}}) {
        const ExactPacking packing = exact_packing(h, position, radius, jitter);
        Triangulation result;
        if (!join_parts(packing, triangulate_parts(packing, choose_cuts(packing, parts), care), result)) {
            defect = "images of the cell are not triangulated alike";
            continue;
        }
        const auto found = find_defect(result, h, position);
        if (!found) {
            result.jitter = jitter * packing.spacing * packing.unit;
            return result;
        }
        defect = *found;
    }
    throw GeometryError(fmt::format(
        "pores: the triangulation of {} grains is not that of a periodic cell: {}. Do grains coincide?", radius.size(),
        defect
    ));
}

} // namespace suffuse::pores
