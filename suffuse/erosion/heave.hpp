#pragma once
// The gradient at which seepage carries the whole soil.

#include "suffuse/base/vec3.hpp"
#include "suffuse/erosion/spec.hpp"

#include <optional>

namespace suffuse::erosion {

/// Of upward seepage: (1 - n)(rho_s - rho_f)/rho_f [Terzaghi1939].
inline double critical_gradient(double porosity, double grain_density, double fluid_density) {
    return (1 - porosity) * (grain_density - fluid_density) / fluid_density;
}

/// The same for seepage along `direction`, which lifts by its upward part; nothing where it does not rise.
inline std::optional<double> heave_gradient(double critical_gradient, const Gravity& gravity, const Vec3& direction) {
    constexpr double level = 1e-6; // a direction that was meant to be so, and rounded
    const double rise = -dot(gravity.down, direction) / norm(direction);
    return rise > level ? std::optional(critical_gradient / rise) : std::nullopt;
}

} // namespace suffuse::erosion
