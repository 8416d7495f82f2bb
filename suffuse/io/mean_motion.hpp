#pragma once
// The mean motion of grains that move with a deforming cell: the velocity gradient that their velocities show.

#include "suffuse/base/vec3.hpp"
#include "suffuse/grains/grains.hpp"

#include <optional>

namespace suffuse::io {

/// dv/dx of the motion v = v0 + (dv/dx) x that fits the velocities best (least squares) [1/s]; nothing where it
/// explains less than half of their scatter, or the grains lie in a plane. Velocities of a packing at rest, or of
/// grains that only rattle, show none.
std::optional<Mat3> find_velocity_gradient(const grains::Grains& grains);

} // namespace suffuse::io
