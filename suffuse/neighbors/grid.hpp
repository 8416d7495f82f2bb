#pragma once
// Grains of one size class, sorted into bins of the periodic cell.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/bins.hpp"
#include "suffuse/cell/cell.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::neighbors {

/// Wrapped coordinates of all grains, shared by the grids of all classes.
struct HomePositions {
    std::vector<Vec3> fraction;      ///< of the cell vectors, in [0, 1) [-]
    std::vector<Vec3> position;      ///< inside the cell [m]
    std::vector<cell::Image> period; ///< that was taken off
};

HomePositions bring_home(const Mat3& h, std::vector<Vec3> position);

struct Grid {
    cell::Bins bins;
    double largest_radius = 0;        ///< of the class [m]
    std::vector<std::uint32_t> start; ///< first row of `grain` for each bin, and one past the end
    std::vector<std::uint32_t> grain; ///< grain rows, sorted by bin
};

/// One grid a size class, coarsest first; `members[c]` are the grains of class c.
/// `margin` [m] widens the bins, so that a search of equal grains looks at three an axis.
std::vector<Grid> build_grids(const Mat3& h, const HomePositions& home, std::span<const double> radius, double margin);

/// Size class of a radius: 0 for the largest, one more for each halving.
int size_class(double radius, double largest_radius);

} // namespace suffuse::neighbors
