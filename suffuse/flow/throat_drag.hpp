#pragma once
// What the grains of one throat hold its water back with, for a viscosity of 1. It is bounded at both ends: Stokes'
// drag of each grain where the water is wide, flow in a film where it is narrow. docs/theory/pore-flow.md, "Bounded
// drag".

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace suffuse::flow {

/// Drag of a lone sphere over its surface, times its radius: 6 pi r / (4 pi r2). Exact.
inline constexpr double stokes = 1.5;

/// Drag of a film over its surface, times its thickness. Fitted to resolved flows, as all that follows.
inline constexpr double film = 3.7;

/// The same, where it gives how the grains of a throat share its drag.
inline constexpr double film_of_share = 4;

/// Layers of water that a grain must be away from a wall to feel the water in full.
inline constexpr double layer_at_wall = 1.0;

/// What the water of a throat touches of its grains.
struct WettedGrains {
    std::array<double, 3> radius{}; ///< [m]
    std::array<double, 3> area{};   ///< [m2]
};

/// Thickness of the layer that this much water [m3] makes on the grains, the same on all [m]: the root of
/// sum of area ((1 + h/r)^3 - 1) r/3 = water. 0 where there is no water, or nothing for it to lie on.
inline double water_layer(const WettedGrains& grains, double water) {
    double linear = 0, square = 0, cube = 0; // coefficients of h, h2, h3
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = grains.radius[k];
        linear += grains.area[k];
        square += grains.area[k] / r;
        cube += grains.area[k] / (3 * r * r);
    }
    if (!(water > 0) || !(linear > 0)) {
        return 0;
    }
    // Each term alone would be wider. From above, Newton's steps on a convex function come down to the root.
    double h = std::min({water / linear, std::sqrt(water / square), std::cbrt(water / cube)});
    for (int step = 0; step < 20; ++step) {
        const double excess = ((cube * h + square) * h + linear) * h - water;
        const double down = excess / ((3 * cube * h + 2 * square) * h + linear);
        h -= down;
        if (!(down > 1e-15 * h)) {
            break;
        }
    }
    return h;
}

/// Drag of all grains over the mean velocity of the water [m]. `open`: what of each wetted surface lies in no wedge
/// next to a contact [m2].
inline double throat_drag(const WettedGrains& grains, const std::array<double, 3>& open, double layer) {
    double drag = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = grains.radius[k];
        drag += grains.area[k] * stokes * (1 / r - 1 / (r + layer)) + open[k] * film / layer;
    }
    return drag;
}

/// Shares of the grains in the drag; they add up to 1. `to_wall`: from the center of each to the nearest surface of a
/// much larger grain [m], behind which water is slower; what it spares one grain goes to those that have none so near.
inline std::array<double, 3>
drag_shares(const WettedGrains& grains, double layer, const std::array<double, 3>& to_wall) {
    std::array<double, 3> share{};
    double whole = 0, spared = 0, open = 0;
    std::array<bool, 3> is_open{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = grains.radius[k], full = grains.area[k] * (stokes / r + film_of_share / layer);
        const double part = std::min(1.0, to_wall[k] / (r + layer_at_wall * layer));
        is_open[k] = part == 1;
        share[k] = part * full;
        whole += full;
        spared += full - share[k];
        open += is_open[k] ? full : 0;
    }
    if (!(whole > 0)) {
        return {1.0 / 3, 1.0 / 3, 1.0 / 3};
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (open > 0) {
            share[k] += is_open[k] ? spared * share[k] / open : 0;
        } else { // none to take over what the others are spared: nobody is spared anything
            share[k] = grains.area[k] * (stokes / grains.radius[k] + film_of_share / layer);
        }
        share[k] /= whole;
    }
    return share;
}

} // namespace suffuse::flow
