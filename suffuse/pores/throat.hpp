#pragma once
// Geometry of one throat: the triangle of three grain centers between two pores [Chareyre 2012]. The water of a throat
// fills the two tetrahedra from the triangle to the two pore centers, less the grains; the solid it touches is counted
// by solid angles. Measures as in Yade 2023.02a, which agree with it to rounding. Grains overlap little or not at all.

#include "suffuse/base/vec3.hpp"

#include <array>
#include <cstddef>

namespace suffuse::pores {

/// Solid angle of the triangle (a, b, c) seen from the origin [sr], positive where a, b, c turn left seen from there.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c);

/// The circle in the plane of three grain centers that touches the three grains. Alone it is no constriction: three
/// grains with a common tangent have one as large as one likes, with its center far from them (facet_room.hpp).
struct InscribedCircle {
    Vec3 center;            ///< relative to the first grain center [m]
    double radius = 0;      ///< 0 where none fits; negative where the grains overlap over the whole triangle [m]
    bool is_inside = false; ///< its center lies in the triangle, or on an edge of it
};

/// `b`, `c`: centers of the second and third grain relative to the first [m]; `r`: radii [m].
InscribedCircle inscribed_circle(const Vec3& b, const Vec3& c, const std::array<double, 3>& r);

struct ThroatGeometry {
    Vec3 area;                       ///< of the triangle, pointing from pore center 1 to pore center 2 [m2]
    double void_area = 0;            ///< of the triangle, without its sections of grains [m2]
    double solid_surface = 0;        ///< wetted by the throat's water [m2]
    double hydraulic_radius = 0;     ///< water volume over solid surface [m]
    std::array<double, 3> section{}; ///< of each grain by the triangle [m2]
    std::array<double, 3> wetted{};  ///< the part of the solid surface that is each grain's [m2]

    /// Part of the pressure difference x area that grain k receives: by its section, and of the void area by its part
    /// of the solid surface [-].
    [[nodiscard]] double grain_share(std::size_t k) const {
        return (section[k] + void_area * (solid_surface > 0 ? wetted[k] / solid_surface : 1.0 / 3)) / norm(area);
    }
};

/// Measures the throat between pore centers `p1`, `p2` through the grains at `x` with radii `r` [m]. The triangle x
/// turns left seen from p2.
ThroatGeometry
measure_throat(const std::array<Vec3, 3>& x, const std::array<double, 3>& r, const Vec3& p1, const Vec3& p2);

} // namespace suffuse::pores
