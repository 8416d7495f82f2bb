#pragma once
// The power center of a tetrahedron of spheres: the point with the same power |P - x|^2 - w with respect to all four.

#include "suffuse/base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::pores {

struct PowerCenter {
    Vec3 point;           ///< [m]
    bool is_flat = false; ///< four centers in one plane to rounding: the point means nothing
};

/// Volume over cubed longest edge below which a tetrahedron counts as flat. Such slivers arise where many grains lie on
/// one sphere, as in lattices; rounding moves their center by about 1e-15 / this of their size.
inline constexpr double flat_volume = 1e-9;

/// Power center of the spheres around `x` with weights `w` = r^2 [m], [m2]. Corners in any order.
inline PowerCenter power_center(const std::array<Vec3, 4>& x, const std::array<double, 4>& w) {
    const Vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    const double six_volumes = dot(a, cross(b, c));
    const double longest2 = std::max({norm2(a), norm2(b), norm2(c), norm2(b - a), norm2(c - a), norm2(c - b)});
    if (!(std::abs(six_volumes) > 6 * flat_volume * longest2 * std::sqrt(longest2))) {
        return {x[0], true};
    }
    const double qa = norm2(a) - w[1] + w[0], qb = norm2(b) - w[2] + w[0], qc = norm2(c) - w[3] + w[0];
    const Vec3 offset = qa * cross(b, c) + qb * cross(c, a) + qc * cross(a, b);
    return {x[0] + (0.5 / six_volumes) * offset, false};
}

} // namespace suffuse::pores
