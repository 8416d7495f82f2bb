#pragma once
// Weighted Delaunay (regular, weight r^2) triangulation of a periodic packing in a cell of any shape. Images of the
// grains around the cell are made here, as many as needed: every tetrahedron that is kept has been shown to have no
// image of any grain in conflict with it. Kept is the one image of each tetrahedron whose centroid lies in the cell.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::pores {

/// One row a tetrahedron. Corner k is the point position[grain[k]] + shift(h, grain_image[k]), positions being those
/// given, not wrapped; corners are in positive order. Across the facet opposite to corner k lies `neighbor[k]`, moved
/// by shift(h, neighbor_image[k]).
struct Triangulation {
    std::vector<std::array<std::uint32_t, 4>> grain;
    std::vector<std::array<cell::Image, 4>> grain_image;
    std::vector<std::array<std::uint32_t, 4>> neighbor;
    std::vector<std::array<cell::Image, 4>> neighbor_image;

    std::vector<std::uint32_t> hidden; ///< grains buried so deep that no tetrahedron has them: they have no pores
    std::size_t ghosts = 0;            ///< images that were needed around the cell and its parts
    double margin = 0;                 ///< distance from the cell to which surfaces of images were needed [m]
    double jitter = 0; ///< largest displacement used to decide degenerate cases, 0 where none was needed [m]

    [[nodiscard]] std::size_t size() const { return grain.size(); }
};

/// Triangulates the packing in the periodic cell with vectors `h` (columns) [m], in up to `parts` parts of the cell on
/// several threads; 0 takes as many as suit the number of grains. The tetrahedra are the same for any number of parts.
/// The result satisfies find_defect() == nullopt. @throws GeometryError for input that is not a packing.
Triangulation triangulate(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, int parts = 0);

} // namespace suffuse::pores
