#pragma once
// What lies along the three edges of a throat, each between two grains: where these overlap, what solid angles and
// sections count twice; where they nearly touch, the wedge in which water rests and what it wets drags little.
// docs/theory/pore-flow.md, "Bounded drag".

#include "suffuse/base/constants.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/flow/throat_drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace suffuse::flow {

/// Edge k of a throat goes from its grain k to the next.
class ThroatEdges {
public:
    /// `x`: centers of the grains; `p1`, `p2`: the pore centers on both sides [m].
    ThroatEdges(const std::array<Vec3, 3>& x, const Vec3& p1, const Vec3& p2) : x_(x), p1_(p1), p2_(p2) {
        for (std::size_t k = 0; k < 3; ++k) {
            edge_[k] = x[(k + 1) % 3] - x[k];
            length_[k] = norm(edge_[k]);
        }
    }

    /// [m]
    [[nodiscard]] double length(std::size_t k) const { return length_[k]; }

    /// From one pore center to the other around the edge: the water's share of its surroundings. Few need it [rad].
    [[nodiscard]] double angle(std::size_t k) const {
        if (angle_[k] < 0) {
            const Vec3& edge = edge_[k];
            const Vec3 one = p1_ - x_[k], two = p2_ - x_[k];
            angle_[k] = std::atan2(
                length_[k] * std::abs(dot(edge, cross(one, two))),
                length_[k] * length_[k] * dot(one, two) - dot(edge, one) * dot(edge, two)
            );
        }
        return angle_[k];
    }

private:
    std::array<Vec3, 3> x_, edge_;
    Vec3 p1_, p2_;
    std::array<double, 3> length_{};
    mutable std::array<double, 3> angle_{-1, -1, -1}; ///< below 0 until requested
};

/// What two overlapping spheres have in common.
struct Lens {
    std::array<double, 2>
        cap{};               ///< surface of each within the other, over the angle about the line of centers [m2/rad]
    double volume = 0;       ///< [m3/rad]
    double half_section = 0; ///< on one side of the line of centers, in a plane through it, within 1 % [m2]
};

/// Of the circle in which two spheres meet, from the first center [m].
inline double meeting_plane(double ra, double rb, double distance) {
    return distance > 0 ? 0.5 * (distance + (ra * ra - rb * rb) / distance) : 0;
}

/// @pre distance < ra + rb. Of a sphere within the other all is common.
inline Lens lens_of(double ra, double rb, double distance) {
    const double d = std::max(distance, std::abs(ra - rb)), plane = meeting_plane(ra, rb, d);
    const double ha = ra - plane, hb = rb - (d - plane);
    const double chord = 2 * std::sqrt(std::max(0.0, ra * ra - plane * plane));
    const auto flat_segment = [&](double height) {
        return chord > 0 ? height * (2 * chord / 3 + height * height / (2 * chord)) : 0;
    };
    const auto segment = [&](double r, double height) {
        return height <= r ? flat_segment(height) : pi * r * r - flat_segment(2 * r - height);
    };
    return {
        {ra * ha, rb * hb},
        (ha * ha * (3 * ra - ha) + hb * hb * (3 * rb - hb)) / 6,
        0.5 * (segment(ra, ha) + segment(rb, hb))};
}

/// Surface of each of two spheres, over the angle about their line of centers, where less than `gap` is between them
/// along that line: the caps of the lens that they would have if moved together by the gap, no larger than up to the
/// equator of the smaller sphere. 0 where they are farther apart [m2/rad].
inline std::array<double, 2> wedge_caps(double ra, double rb, double distance, double gap) {
    if (!(distance - gap < ra + rb)) {
        return {};
    }
    const double moved = std::max(distance - gap, std::sqrt(std::abs(ra * ra - rb * rb)));
    const double plane = meeting_plane(ra, rb, moved);
    return {ra * (ra - plane), rb * (rb - (moved - plane))};
}

/// What of the grains' surfaces lies in no wedge narrower than `gap`; `area` by solid angles, and below 0 where wedges
/// overlap. Lengths [m], surfaces [m2].
inline std::array<double, 3> surface_beyond_wedges(const ThroatEdges& edges, const WettedGrains& grains, double gap) {
    std::array<double, 3> open = grains.area;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        const auto [cap_of_a, cap_of_b] = wedge_caps(grains.radius[a], grains.radius[b], edges.length(a), gap);
        if (cap_of_a > 0) {
            open[a] -= edges.angle(a) * cap_of_a;
            open[b] -= edges.angle(a) * cap_of_b;
        }
    }
    return open;
}

/// The water of a throat and what it wets.
struct ThroatWater {
    double volume = 0; ///< [m3]
    WettedGrains grains;
};

/// Counts once what grains that overlap have in common: `counted` is by solid angles. Exact where no three overlap.
inline ThroatWater count_overlaps_once(const ThroatEdges& edges, ThroatWater counted) {
    auto& [radius, area] = counted.grains;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        if (edges.length(a) < radius[a] + radius[b]) {
            const Lens lens = lens_of(radius[a], radius[b], edges.length(a));
            const double angle = edges.angle(a);
            counted.volume += angle * lens.volume;
            area[a] -= angle * lens.cap[0];
            area[b] -= angle * lens.cap[1];
        }
    }
    counted.volume = std::max(0.0, counted.volume);
    for (double& each : area) {
        each = std::max(0.0, each);
    }
    return counted;
}

} // namespace suffuse::flow
