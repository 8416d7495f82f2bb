#pragma once
// The size of the circle or sphere that touches spheres from between them: differences of |center - x_k| = size + r_k
// are linear, center - x_0 = u + size v, and what is left is a quadratic.

#include "suffuse/base/vec3.hpp"

#include <cmath>
#include <optional>

namespace suffuse::pores {

/// The least size > 0 with |u + size v| = size + r [m], or a negative one where the spheres overlap all that is between
/// them; nothing where there is none.
inline std::optional<double> tangent_size(const Vec3& u, const Vec3& v, double r) {
    const double p = r - dot(u, v), q = norm2(u) - r * r;
    const double discriminant = p * p + (1 - norm2(v)) * q;
    const double divisor = p + std::sqrt(std::fmax(discriminant, 0.0));
    if (!(discriminant >= 0) || !(divisor > 0)) {
        return std::nullopt;
    }
    return q / divisor;
}

} // namespace suffuse::pores
