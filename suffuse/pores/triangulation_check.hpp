#pragma once
// What every triangulation of a periodic cell must satisfy, whatever made it.

#include "suffuse/pores/triangulation.hpp"

#include <optional>
#include <string>

namespace suffuse::pores {

/// What is wrong with the triangulation, or nothing. Checked: the volumes of the tetrahedra add up to that of the cell
/// (relative 1e-10), each facet has its two sides, and V - E + F - C = 0, the Euler characteristic of the 3-torus.
std::optional<std::string> find_defect(const Triangulation& t, const Mat3& h, std::span<const Vec3> position);

/// Volume of a tetrahedron with corners in positive order [m3].
constexpr double tetrahedron_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(b - a, cross(c - a, d - a)) / 6;
}

/// Corners of tetrahedron `p` [m].
inline std::array<Vec3, 4>
corners_of(const Triangulation& t, std::size_t p, const Mat3& h, std::span<const Vec3> position) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) {
        x[k] = position[t.grain[p][k]] + shift(h, t.grain_image[p][k]);
    }
    return x;
}

/// Facet of `neighbor[k]` that is the facet k of tetrahedron `p`; 4 where there is none.
inline std::size_t facet_from_other_side(const Triangulation& t, std::size_t p, std::size_t k) {
    const std::uint32_t q = t.neighbor[p][k];
    const cell::Image back = -t.neighbor_image[p][k];
    for (std::size_t j = 0; j < 4; ++j) {
        if (t.neighbor[q][j] == p && t.neighbor_image[q][j] == back) {
            return j;
        }
    }
    return 4;
}

} // namespace suffuse::pores
