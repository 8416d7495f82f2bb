#pragma once
// Grains brought home into the cell, as formats want them whose readers know of no periods.

#include "suffuse/cell/cell.hpp"

namespace suffuse::io {

struct MovingPoint {
    Vec3 position, velocity; ///< [m], [m/s]
};

/// The image of `point` inside the cell: where the cell deforms, it moves as the mean motion does there.
inline MovingPoint brought_home(const cell::Cell& cell, const Mat3& inverse_h, const MovingPoint& point) {
    const Vec3 away = cell::shift(cell.h, cell::period_of(inverse_h, point.position));
    return {point.position - away, point.velocity - cell.velocity_gradient * away};
}

} // namespace suffuse::io
