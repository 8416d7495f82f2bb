#pragma once
// The largest stable time step of the explicit scheme, from the stiffest mode of the contact network: translations and
// rotations coupled, rolling and twisting springs included.

#include "suffuse/dem/world.hpp"

namespace suffuse::dem {

/// Share of the stability limit that is taken: the power iteration is a few percent low, and contacts come and go.
inline constexpr double default_step_safety = 0.75;

/// Highest angular frequency of the network of touching contacts [rad/s]; 0 without contacts. All of them stick, but
/// for frictionless grains at rest in rotation: only their normal springs act. Power iteration on M^-1 K: it comes from
/// below, within a few percent after `iterations`.
double highest_frequency(const World& world, int iterations = 40);

/// `safety` x 2 / highest frequency, and never above `safety` x what an uncompressed pair of the smallest grains
/// allows, so that it holds for contacts still to come [s].
double stable_time_step(const World& world, double safety = default_step_safety);

} // namespace suffuse::dem
