#include "suffuse/pores/triangulation.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/pores/lattice.hpp"
#include "suffuse/pores/part_of_cell.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::pores {
namespace {

/// Number of parts worth their images: two of 10,000 grains, which have a tenth more images than one; 16 of a million.
int suitable_parts(std::size_t grains) {
    constexpr double grains_in_two = 10'000;
    return static_cast<int>(2 * std::sqrt(static_cast<double>(grains) / grains_in_two));
}

/// Halves the widest side of the parts until there are enough of them; depends on the packing only.
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

std::vector<PartTetrahedra> triangulate_parts(const ExactPacking& packing, const Cuts& cuts) {
    std::vector<PartTetrahedra> parts(static_cast<std::size_t>(cuts[0] * cuts[1] * cuts[2]));
    parallel_for(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            const int k = static_cast<int>(p);
            const Part part = {k % cuts[0], k / cuts[0] % cuts[1], k / (cuts[0] * cuts[1])};
            parts[p] = triangulate_part(packing, cuts, part);
        }
    });
    return parts;
}

/// A tetrahedron of a part, and where it stands among all.
struct Entry {
    std::uint64_t place;
    std::uint32_t part, row;
};

/// All tetrahedra along the curve that fills the cell, so that what is close in space is close in memory.
std::vector<Entry> order_tetrahedra(const std::vector<PartTetrahedra>& parts) {
    std::vector<Entry> order;
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
        for (std::uint32_t row = 0; row < parts[part].corner.size(); ++row) {
            order.push_back({parts[part].place[row], part, row});
        }
    }
    std::sort(order.begin(), order.end(), [&](const Entry& one, const Entry& other) {
        return one.place != other.place ? one.place < other.place
                                        : parts[one.part].corner[one.row] < parts[other.part].corner[other.row];
    });
    return order;
}

/// A facet of a tetrahedron whose other side lies in another part, or is an image of one that is kept. (That image as
/// triangulated here may be wrong: only kept tetrahedra are known to have all images around them.)
struct OpenFacet {
    Canonical<3> facet;
    std::uint32_t p, k;
};

/// Joins the two sides of every open facet; false where there are not two.
bool close(std::vector<OpenFacet>& open, const CompactBasis& basis, Triangulation& out) {
    std::sort(open.begin(), open.end(), [](const OpenFacet& one, const OpenFacet& other) {
        return one.facet.corners < other.facet.corners;
    });
    if (open.size() % 2 != 0) {
        return false;
    }
    for (std::size_t f = 0; f < open.size(); f += 2) {
        const OpenFacet &one = open[f], &other = open[f + 1];
        if (one.facet.corners != other.facet.corners) {
            return false;
        }
        const cell::Image between = basis.original(one.facet.moved - other.facet.moved);
        out.neighbor[one.p][one.k] = other.p;
        out.neighbor_image[one.p][one.k] = between;
        out.neighbor[other.p][other.k] = one.p;
        out.neighbor_image[other.p][other.k] = -between;
    }
    return true;
}

/// The tetrahedra of all parts as one table; false where images of the cell, or two parts, are not triangulated alike.
bool join_parts(const ExactPacking& packing, const std::vector<PartTetrahedra>& parts, Triangulation& out) {
    const std::vector<Entry> order = order_tetrahedra(parts);
    std::vector<std::vector<std::uint32_t>> number;
    for (const PartTetrahedra& part : parts) {
        number.emplace_back(part.corner.size());
        out.ghosts += part.points;
        out.margin = std::max(out.margin, part.reach * packing.unit);
    }
    out.ghosts -= packing.radius.size();
    for (std::uint32_t p = 0; p < order.size(); ++p) {
        number[order[p].part][order[p].row] = p;
    }
    out.grain.resize(order.size()), out.grain_image.resize(order.size());
    out.neighbor.resize(order.size()), out.neighbor_image.resize(order.size());
    std::vector<std::uint8_t> seen(packing.radius.size(), 0);
    std::vector<OpenFacet> open;
    for (std::uint32_t p = 0; p < order.size(); ++p) {
        const PartTetrahedra& part = parts[order[p].part];
        const std::array<Corner, 4>& corner = part.corner[order[p].row];
        for (std::uint32_t k = 0; k < 4; ++k) {
            const Corner& c = corner[k];
            seen[c.grain] = 1;
            out.grain[p][k] = c.grain;
            out.grain_image[p][k] = packing.basis.original(c.image - packing.period[c.grain]);
            const std::uint32_t neighbor = part.neighbor[order[p].row][k];
            if (neighbor != PartTetrahedra::none) {
                out.neighbor[p][k] = number[order[p].part][neighbor];
                continue;
            }
            const auto facet = std::array{corner[(k + 1) % 4], corner[(k + 2) % 4], corner[(k + 3) % 4]};
            open.push_back({canonical(facet), p, k});
        }
    }
    for (std::uint32_t g = 0; g < seen.size(); ++g) {
        if (seen[g] == 0) {
            out.hidden.push_back(g);
        }
    }
    return close(open, packing.basis, out);
}

} // namespace

Triangulation triangulate(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, int parts) {
    // Exact predicates with a translation-invariant tie rule serve lattices as they are. Should images of the cell be
    // triangulated differently after all, grains are moved by a trifle to decide the ties; geometry keeps the true
    // ones.
    std::string defect;
    for (const double jitter : {0.0, 1e-9, 1e-7}) {
        const ExactPacking packing = exact_packing(h, position, radius, jitter);
        Triangulation result;
        if (!join_parts(packing, triangulate_parts(packing, choose_cuts(packing, parts)), result)) {
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
