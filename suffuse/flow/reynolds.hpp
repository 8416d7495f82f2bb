#pragma once
// Whether water seeps slowly enough for a flow without inertia: its Reynolds number, and what inertia would leave of
// the flux by the resistance of packed spheres [Ergun1952], in which a viscous and an inertial part add up: |grad p| =
// 150 mu (1 - n)^2 v/(n^3 d^2) + 1.75 rho (1 - n) v^2/(n^3 d).

#include "suffuse/flow/fluid.hpp"

#include <span>
#include <string>

namespace suffuse::flow {

/// Sum of cubes over sum of squares: equal spheres of this diameter have as much surface in their volume [m]; 0 without
/// grains.
double sauter_diameter(std::span<const double> radius);

/// Superficial velocity under a hydraulic gradient of 1 [m/s]; `permeability` [m2].
double conductivity(double permeability, const Fluid& fluid);

/// rho v d/mu with the superficial velocity of the slow flow [-]; `permeability` [m2], `diameter` [m].
double reynolds_number(double permeability, double gradient, double diameter, const Fluid& fluid);

/// Flux with inertia over that of the slow flow under the same gradient, 1 where inertia does not count [-].
double share_left_by_inertia(double reynolds, double porosity);

/// What slow flow leaves out at a hydraulic gradient, to follow a colon; nothing where inertia takes less than a tenth
/// of the flux. `where`: "in the sample".
std::string words_of_inertia(const std::string& where, double gradient, double reynolds, double porosity);

} // namespace suffuse::flow
