#pragma once
// Planes across the flow in a periodic cell.

#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <cmath>

namespace suffuse::erosion {

/// The period of the cell along a direction [m].
inline double period_along(const Mat3& h, const Vec3& direction) {
    return std::abs(dot(h.column(pores::axis_along(h, direction)), direction)) / norm(direction);
}

/// Whether planes across the direction are planes of the cell: its two other edges lie in them.
inline bool has_planes_across(const Mat3& h, const Vec3& direction) {
    constexpr double tilted = 1e-6;
    const double most = tilted * period_along(h, direction) * norm(direction);
    const int along = pores::axis_along(h, direction);
    return std::abs(dot(h.column((along + 1) % 3), direction)) <= most &&
           std::abs(dot(h.column((along + 2) % 3), direction)) <= most;
}

} // namespace suffuse::erosion
