#pragma once
// A staggered grid over a right-angled periodic cell [HarlowWelch1965]: velocities stand on the faces of its boxes,
// each component on those normal to it, pressures in the middle.

#include "suffuse/base/vec3.hpp"

#include <array>
#include <cstddef>

namespace suffuse::stokes {

struct Grid {
    std::array<std::size_t, 3> boxes{}; ///< along x, y, z
    Vec3 spacing;                       ///< [m]

    [[nodiscard]] std::size_t size() const { return boxes[0] * boxes[1] * boxes[2]; }

    [[nodiscard]] std::size_t rows() const { return boxes[0] * boxes[1]; }

    /// Numbers in a row along z as fields are stored: the transform of a row wants two more than it has boxes.
    [[nodiscard]] std::size_t row_length() const { return 2 * (boxes[2] / 2 + 1); }

    /// Numbers of one stored field.
    [[nodiscard]] std::size_t field_size() const { return rows() * row_length(); }
};

/// Whether the cell's edges lie along x, y, z.
bool is_right_angled(const Mat3& h);

/// Along an axis of so many spacings: the least even product of 2, 3, 5 and 7 that is not below.
std::size_t boxes_along(double spacings);

/// The coarsest grid of spacing at most `spacing` [m] whose axes have such numbers of boxes.
/// @throws GeometryError for a cell that is not right-angled along x, y, z, or one of more than 2^31 boxes.
Grid grid_over(const Mat3& h, double spacing);

} // namespace suffuse::stokes
