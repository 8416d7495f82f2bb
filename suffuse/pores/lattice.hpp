#pragma once
// A periodic packing brought to a form that a triangulation of plain points can treat exactly: the most compact cell of
// the same lattice, lengths scaled by a power of two to the size of the cell, coordinates and cell vectors rounded to a
// common binary grid. On it, every image of a grain is its exact translate, so exact predicates decide the same for all
// images.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"

#include <array>
#include <span>
#include <vector>

namespace suffuse::pores {

/// The most compact basis of the lattice of `h`: h * change, where `change` is unimodular.
struct CompactBasis {
    Mat3 h;                                   ///< [m]
    std::array<std::array<int, 3>, 3> change; ///< [row][column]

    /// The image in terms of the original cell vectors.
    [[nodiscard]] cell::Image original(const cell::Image& image) const {
        const auto row = [&](std::size_t k) {
            return change[k][0] * image.a + change[k][1] * image.b + change[k][2] * image.c;
        };
        return {row(0), row(1), row(2)};
    }
};

/// Reduces the cell vectors by each other until none gets shorter; keeps the orientation of `h`.
CompactBasis compact_basis(const Mat3& h);

/// The packing on the exact grid. One row a grain; all lengths in units of `unit`.
struct ExactPacking {
    CompactBasis basis;
    double unit = 1;                 ///< a power of two [m]
    Mat3 h;                          ///< the compact cell on the grid [-]
    Mat3 inverse_h;                  ///< [-]
    Vec3 width;                      ///< distances between opposite faces of the compact cell [-]
    std::vector<Vec3> position;      ///< brought home into the compact cell, on the grid [-]
    std::vector<double> radius;      ///< [-]
    std::vector<cell::Image> period; ///< of the compact cell that the grain lay in
    double spacing = 0;              ///< cube root of the volume per grain [-]
};

/// Brings a packing to the exact grid. `jitter` moves every grain by up to that share of the spacing, the same for the
/// same row in every run. @throws GeometryError for what is not a packing: not finite, no volume, grains wider than the
/// cell.
ExactPacking
exact_packing(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, double jitter = 0);

} // namespace suffuse::pores
