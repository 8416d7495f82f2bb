#pragma once
// Each constant and each formula of a single sphere, written once.

#include <numbers>

namespace suffuse {

inline constexpr double pi = std::numbers::pi;
inline constexpr double gravity = 9.81; ///< [m/s2], exactly, so that i = 0.05 means the same body force everywhere

/// Volume of a sphere of radius `r` [m3].
constexpr double sphere_volume(double r) {
    return 4.0 / 3.0 * pi * r * r * r;
}

/// Moment of inertia of a full sphere of mass `m` and radius `r` [kg m2].
constexpr double sphere_inertia(double m, double r) {
    return 0.4 * m * r * r;
}

constexpr double radians(double degrees) {
    return degrees * (pi / 180.0);
}

constexpr double degrees(double radians) {
    return radians * (180.0 / pi);
}

} // namespace suffuse
