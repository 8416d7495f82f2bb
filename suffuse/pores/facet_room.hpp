#pragma once
// The room in a facet: the largest sphere that is centered in the triangle of three grain centers and reaches into no
// grain. A sphere whose center goes from one pore into the next crosses their facet somewhere, so that none that is
// larger passes it. Where the circle that touches the three grains has its center in the triangle and meets no fourth
// grain, it is that sphere's [Reboul 2008]; elsewhere two of the grains on an edge, or a fourth grain, bound it.

#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/throat.hpp"

#include <array>
#include <cstddef>

namespace suffuse::pores {

/// Grains around a facet that may reach into its room: the far corners of its two tetrahedra, and those of the six
/// behind these. Relative to the first grain of the facet [m].
struct NearGrains {
    static constexpr std::size_t most = 8;
    std::array<Vec3, most> center;
    std::array<double, most> radius{};
    std::size_t size = 0;

    void add(const Vec3& x, double r) { center[size] = x, radius[size++] = r; }
};

/// Whether near grain `k` reaches into the circle, seen as a sphere, by more than rounding: circles of four grains of a
/// lattice meet all four.
inline bool reaches_in(const NearGrains& near, std::size_t k, const InscribedCircle& circle) {
    constexpr double rounding = 1e-12;
    const double apart = (circle.radius + near.radius[k]) * (1 - rounding);
    return norm2(near.center[k] - circle.center) < apart * apart;
}

inline bool is_free(const InscribedCircle& circle, const NearGrains& near) {
    for (std::size_t k = 0; k < near.size; ++k) {
        if (reaches_in(near, k, circle)) {
            return false;
        }
    }
    return true;
}

/// The largest sphere centered in the triangle of the grains with radii `r` around 0, `b` and `c`, free of them and of
/// those near, where the `circle` that touches the three is not [m]. Negative where grains fill the triangle.
InscribedCircle largest_in_facet(
    const Vec3& b, const Vec3& c, const std::array<double, 3>& r, const InscribedCircle& circle, const NearGrains& near
);

} // namespace suffuse::pores
