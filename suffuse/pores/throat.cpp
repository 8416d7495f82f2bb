#include "suffuse/pores/throat.hpp"

#include "suffuse/pores/tangent.hpp"

#include <cmath>

namespace suffuse::pores {
namespace {

/// Tangent of half a solid angle as a fraction [Van Oosterom and Strackee 1983].
struct HalfAngle {
    double numerator, denominator;
};

HalfAngle half_solid_angle(const Vec3& a, double la, const Vec3& b, double lb, const Vec3& c, double lc) {
    return {dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb};
}

/// Part of a disk of radius r around `corner` beyond the opposite edge (b, c) of the triangle [m2].
double segment_beyond(const Vec3& corner, const Vec3& b, const Vec3& c, double r, double twice_area) {
    const Vec3 edge = c - b;
    const double along = dot(corner - b, edge), length2 = norm2(edge);
    if (along < 0 || along > length2) {
        return 0;
    }
    const double h = twice_area / std::sqrt(length2);
    if (h >= r) {
        return 0;
    }
    return r * r * std::acos(h / r) - h * std::sqrt(r * r - h * h);
}

} // namespace

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const HalfAngle half = half_solid_angle(a, norm(a), b, norm(b), c, norm(c));
    return 2 * std::atan2(half.numerator, half.denominator);
}

InscribedCircle inscribed_circle(const Vec3& b, const Vec3& c, const std::array<double, 3>& r) {
    // |center - x_k| = radius + r_k; differences to the first are linear: center = u + radius v, in the basis (b, c).
    const double bb = norm2(b), bc = dot(b, c), cc = norm2(c), gram = bb * cc - bc * bc;

    struct InBasis {
        double along_b, along_c;
    };

    const auto in_basis = [&](double along_b, double along_c) {
        return InBasis{(along_b * cc - along_c * bc) / gram, (along_c * bb - along_b * bc) / gram};
    };
    const auto in_plane = [&](const InBasis& k) { return k.along_b * b + k.along_c * c; };
    const InBasis u = in_basis(0.5 * (bb + r[0] * r[0] - r[1] * r[1]), 0.5 * (cc + r[0] * r[0] - r[2] * r[2]));
    const InBasis v = in_basis(r[0] - r[1], r[0] - r[2]);
    const Vec3 from = in_plane(u), each = in_plane(v);
    const std::optional<double> radius = tangent_size(from, each, r[0]);
    if (!radius) {
        return {from, 0, false};
    }
    const InBasis at = {u.along_b + *radius * v.along_b, u.along_c + *radius * v.along_c};
    return {from + *radius * each, *radius, at.along_b >= 0 && at.along_c >= 0 && at.along_b + at.along_c <= 1};
}

ThroatGeometry
measure_throat(const std::array<Vec3, 3>& x, const std::array<double, 3>& r, const Vec3& p1, const Vec3& p2) {
    ThroatGeometry throat;
    throat.area = 0.5 * cross(x[1] - x[0], x[2] - x[0]);
    const double area = norm(throat.area);
    double sections = 0, beyond = 0, solid_volume = 0;
    std::array<double, 3> section{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 left = x[(k + 1) % 3] - x[k], right = x[(k + 2) % 3] - x[k];
        const double r2 = r[k] * r[k];
        section[k] = 0.5 * r2 * std::atan2(2 * area, dot(left, right));
        sections += section[k];
        beyond += segment_beyond(x[k], x[(k + 1) % 3], x[(k + 2) % 3], r[k], 2 * area);

        const Vec3 to1 = p1 - x[k], to2 = p2 - x[k];
        const double l1 = norm(to1), l2 = norm(to2);
        const HalfAngle one = half_solid_angle(left, norm(left), to1, l1, to2, l2);
        const HalfAngle two = half_solid_angle(right, norm(right), to1, l1, to2, l2);
        // The sum of the two arctangents by one, from the product of the two complex numbers.
        const double m1 = std::abs(one.numerator), d1 = std::abs(one.denominator);
        const double m2 = std::abs(two.numerator), d2 = std::abs(two.denominator);
        throat.wetted[k] = 2 * r2 * std::atan2(m1 * d2 + m2 * d1, d1 * d2 - m1 * m2);
        throat.solid_surface += throat.wetted[k];
        solid_volume += throat.wetted[k] * r[k] / 3;
    }
    throat.void_area = std::abs(area - sections + beyond);
    const double water = std::abs(dot(throat.area, p2 - p1)) / 3 - solid_volume;
    const bool touches_solid = throat.solid_surface > 0;
    throat.hydraulic_radius = touches_solid ? water / throat.solid_surface : 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double wetted_share = touches_solid ? throat.wetted[k] / throat.solid_surface : 1.0 / 3;
        throat.grain_share[k] = (section[k] + throat.void_area * wetted_share) / area;
    }
    return throat;
}

} // namespace suffuse::pores
