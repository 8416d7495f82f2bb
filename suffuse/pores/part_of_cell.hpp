#pragma once
// The tetrahedra of one part of a periodic cell: the part with as many images of grains around it as it takes to show
// that no image of any grain is in conflict with a tetrahedron that is kept. Parts know nothing of each other. CGAL is
// used by the .cpp alone.

#include "suffuse/pores/corner.hpp"
#include "suffuse/pores/lattice.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace suffuse::pores {

/// How a cell is cut into parts, along each of its compact vectors.
using Cuts = std::array<int, 3>;

/// One of the parts, counted along each vector.
using Part = std::array<int, 3>;

/// The tetrahedra whose centroid lies in the part, in no order. Their corners rise, but for the last two where that
/// takes to make them positive: each tetrahedron is the same whatever the cuts.
struct PartTetrahedra {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::vector<std::array<Corner, 4>> corner;
    std::vector<std::array<std::uint32_t, 4>> neighbor; ///< across the facet opposite to the corner, or none here
    std::vector<std::uint64_t> place;                   ///< of the centroid on a curve that fills the cell
    std::size_t points = 0;                             ///< grains and images that were needed
    double reach = 0;                                   ///< distance from the part at which surfaces were needed [-]
};

/// Which tetrahedra must be free of conflicts with images that are left out.
enum class Care : std::uint8_t {
    Kept,  ///< those that are kept. One that is missing shows when parts are joined: its neighbors have an open facet
    Whole, ///< all that may touch the part, so that none can be missing: takes more images
};

/// @throws GeometryError where no images are enough.
PartTetrahedra
triangulate_part(const ExactPacking& packing, const Cuts& cuts, const Part& part, Care care = Care::Whole);

} // namespace suffuse::pores
