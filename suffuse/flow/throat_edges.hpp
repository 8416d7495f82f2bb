#pragma once
// What lies along the three edges of a throat, each between two grains: where these overlap, what solid angles and
// sections count twice; where they nearly touch, the wedge in which water rests and what it wets drags little.
// docs/theory/pore-flow.md, "Bounded drag".

#include "suffuse/base/arctangent.hpp"
#include "suffuse/base/constants.hpp"
#include "suffuse/base/vec3.hpp"
#include "suffuse/flow/throat_drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace suffuse::flow {

/// Edge k of a throat goes from its grain k to the next.
struct ThroatEdges {
    std::array<double, 3> length{}; ///< [m]
    std::array<double, 3> angle{};  ///< from one pore center to the other: the water's share of the surroundings [rad]

    ThroatEdges() = default;

    /// `x`: centers of the grains; `p1`, `p2`: the pore centers on both sides [m].
    [[gnu::always_inline]] ThroatEdges(const std::array<Vec3, 3>& x, const Vec3& p1, const Vec3& p2) {
#pragma GCC unroll 3
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 edge = x[(k + 1) % 3] - x[k], one = p1 - x[k], two = p2 - x[k];
            const double length2 = norm2(edge);
            length[k] = std::sqrt(length2);
            angle[k] = arctangent(
                length[k] * std::abs(dot(edge, cross(one, two))),
                length2 * dot(one, two) - dot(edge, one) * dot(edge, two)
            );
        }
    }
};

/// What two overlapping spheres have in common.
struct Lens {
    std::array<double, 2>
        cap{};               ///< surface of each within the other, over the angle about the line of centers [m2/rad]
    double volume = 0;       ///< [m3/rad]
    double half_section = 0; ///< on one side of the line of centers, in a plane through it, within 1 % [m2]
};

/// Of the circle in which two spheres meet, from the first center [m].
[[gnu::always_inline]] inline double meeting_plane(double ra, double rb, double distance) {
    return distance > 0 ? 0.5 * (distance + (ra * ra - rb * rb) / distance) : 0;
}

/// Segment of a circle of radius r, as high as given, with this chord, within 1 % [m2].
[[gnu::always_inline]] inline double segment_of(double r, double height, double chord) {
    const double less = height <= r ? height : 2 * r - height;
    const double flat = chord > 0 ? less * (2 * chord / 3 + less * less / (2 * chord)) : 0;
    return height <= r ? flat : pi * r * r - flat;
}

/// @pre distance < ra + rb. Of a sphere within the other all is common.
[[gnu::always_inline]] inline Lens lens_of(double ra, double rb, double distance) {
    const double d = std::max(distance, std::abs(ra - rb)), plane = meeting_plane(ra, rb, d);
    const double ha = ra - plane, hb = rb - (d - plane);
    const double chord = 2 * std::sqrt(std::max(0.0, ra * ra - plane * plane));
    return {
        {ra * ha, rb * hb},
        (ha * ha * (3 * ra - ha) + hb * hb * (3 * rb - hb)) / 6,
        0.5 * (segment_of(ra, ha, chord) + segment_of(rb, hb, chord))};
}

/// Surface of each of two spheres, over the angle about their line of centers, where less than `gap` is between them
/// along that line: the caps of the lens that they would have if moved together by the gap, no larger than up to the
/// equator of the smaller sphere. 0 where they are farther apart [m2/rad].
[[gnu::always_inline]] inline std::array<double, 2> wedge_caps(double ra, double rb, double distance, double gap) {
    const double moved = std::max(distance - gap, std::sqrt(std::abs(ra * ra - rb * rb)));
    const double plane = meeting_plane(ra, rb, moved);
    const bool is_near = distance - gap < ra + rb;
    return {is_near ? ra * (ra - plane) : 0, is_near ? rb * (rb - (moved - plane)) : 0};
}

/// What of the grains' surfaces lies in no wedge narrower than `gap`; `area` by solid angles, and below 0 where wedges
/// overlap. Lengths [m], surfaces [m2].
[[gnu::always_inline]] inline std::array<double, 3>
surface_beyond_wedges(const ThroatEdges& edges, const WettedGrains& grains, double gap) {
    std::array<double, 3> open = grains.area;
#pragma GCC unroll 3
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        const auto [cap_of_a, cap_of_b] = wedge_caps(grains.radius[a], grains.radius[b], edges.length[a], gap);
        open[a] -= edges.angle[a] * cap_of_a;
        open[b] -= edges.angle[a] * cap_of_b;
    }
    return open;
}

/// The water of a throat and what it wets.
struct ThroatWater {
    double volume = 0; ///< [m3]
    WettedGrains grains;
};

/// Counts once what grains that overlap have in common: `counted` is by solid angles. Exact where no three overlap.
[[gnu::always_inline]] inline ThroatWater count_overlaps_once(const ThroatEdges& edges, ThroatWater counted) {
    auto& [radius, area] = counted.grains;
#pragma GCC unroll 3
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3;
        const Lens lens = lens_of(radius[a], radius[b], edges.length[a]);
        const double angle = edges.length[a] < radius[a] + radius[b] ? edges.angle[a] : 0;
        counted.volume += angle * lens.volume;
        area[a] -= angle * lens.cap[0];
        area[b] -= angle * lens.cap[1];
    }
    counted.volume = std::max(0.0, counted.volume);
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
        area[k] = std::max(0.0, area[k]);
    }
    return counted;
}

} // namespace suffuse::flow
