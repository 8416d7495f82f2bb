#pragma once
// What throat.hpp declares, as functions without branches that loops over many throats compile into vector
// instructions.

#include "suffuse/base/arctangent.hpp"
#include "suffuse/pores/throat.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace suffuse::pores {

/// Tangent of half a solid angle as a fraction [Van Oosterom and Strackee 1983].
struct HalfAngle {
    double numerator, denominator;
};

[[gnu::always_inline]] inline HalfAngle
half_solid_angle(const Vec3& a, double la, const Vec3& b, double lb, const Vec3& c, double lc) {
    return {dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb};
}

/// Part of a disk of radius r around `corner` beyond the opposite edge (b, c) of the triangle [m2].
[[gnu::always_inline]] inline double
segment_beyond(const Vec3& corner, const Vec3& b, const Vec3& c, double r, double twice_area) {
    const Vec3 edge = c - b;
    const double along = dot(corner - b, edge), length2 = norm2(edge);
    const double h = twice_area / std::sqrt(length2), half_chord = std::sqrt(std::max(0.0, r * r - h * h));
    const bool is_outside = (along < 0) | (along > length2); // no branch
    return is_outside ? 0 : r * r * arctangent(half_chord, h) - h * half_chord;
}

[[gnu::always_inline]] inline double solid_angle_of(const Vec3& a, const Vec3& b, const Vec3& c) {
    const HalfAngle half = half_solid_angle(a, norm(a), b, norm(b), c, norm(c));
    return 2 * arctangent(half.numerator, half.denominator);
}

[[gnu::always_inline]] inline ThroatGeometry
geometry_of_throat(const std::array<Vec3, 3>& x, const std::array<double, 3>& r, const Vec3& p1, const Vec3& p2) {
    ThroatGeometry throat;
    throat.area = 0.5 * cross(x[1] - x[0], x[2] - x[0]);
    const double area = norm(throat.area);
    double sections = 0, beyond = 0, solid_volume = 0;
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 left = x[(k + 1) % 3] - x[k], right = x[(k + 2) % 3] - x[k];
        const double r2 = r[k] * r[k];
        throat.section[k] = 0.5 * r2 * arctangent(2 * area, dot(left, right));
        sections += throat.section[k];
        beyond += segment_beyond(x[k], x[(k + 1) % 3], x[(k + 2) % 3], r[k], 2 * area);

        const Vec3 to1 = p1 - x[k], to2 = p2 - x[k];
        const double l1 = norm(to1), l2 = norm(to2);
        const HalfAngle one = half_solid_angle(left, norm(left), to1, l1, to2, l2);
        const HalfAngle two = half_solid_angle(right, norm(right), to1, l1, to2, l2);
        // The sum of the two arctangents by one, from the product of the two complex numbers.
        const double m1 = std::abs(one.numerator), d1 = std::abs(one.denominator);
        const double m2 = std::abs(two.numerator), d2 = std::abs(two.denominator);
        throat.wetted[k] = 2 * r2 * arctangent(m1 * d2 + m2 * d1, d1 * d2 - m1 * m2);
        throat.solid_surface += throat.wetted[k];
        solid_volume += throat.wetted[k] * r[k] / 3;
    }
    throat.void_area = std::abs(area - sections + beyond);
    const double water = std::abs(dot(throat.area, p2 - p1)) / 3 - solid_volume;
    throat.hydraulic_radius = throat.solid_surface > 0 ? water / throat.solid_surface : 0;
    return throat;
}

} // namespace suffuse::pores
