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

/// What the layer's thickness h solves: linear h + square h2 + cube h3 = water, sum of area ((1 + h/r)^3 - 1) r/3.
struct LayerEquation {
    double linear = 0, square = 0, cube = 0, water = 0;

    [[gnu::always_inline]] static LayerEquation of(const WettedGrains& grains, double water) {
        LayerEquation equation;
#pragma GCC unroll 3
        for (std::size_t k = 0; k < 3; ++k) {
            const double r = grains.radius[k];
            equation.linear += grains.area[k];
            equation.square += grains.area[k] / r;
            equation.cube += grains.area[k] / (3 * r * r);
        }
        equation.water = water;
        return equation;
    }

    /// Each term alone would be wider. From above, Newton's steps on a convex function come down to the root.
    [[nodiscard, gnu::always_inline]] double start() const {
        return std::min(water / linear, std::sqrt(water / square));
    }

    /// Newton's step down from h.
    [[nodiscard, gnu::always_inline]] double step(double h) const {
        const double excess = ((cube * h + square) * h + linear) * h - water;
        return excess / ((3 * cube * h + 2 * square) * h + linear);
    }

    /// Whether another one follows.
    [[gnu::always_inline]] static bool goes_on(double step, double h) {
        return step > 1e-15 * h;
    }

    [[nodiscard, gnu::always_inline]] double layer(double root) const {
        return water > 0 && linear > 0 ? root : 0;
    }
};

inline constexpr int most_steps = 40; ///< far more than layers of a million radii need

/// Thickness of the layer that this much water [m3] makes on the grains, the same on all [m]. 0 where there is no
/// water, or nothing for it to lie on.
inline double water_layer(const WettedGrains& grains, double water) {
    const LayerEquation equation = LayerEquation::of(grains, water);
    double h = equation.start(), step = h;
    for (int i = 0; i < most_steps && LayerEquation::goes_on(step, h); ++i) {
        step = equation.step(h);
        h -= step;
    }
    return equation.layer(h);
}

/// Drag of all grains over the mean velocity of the water [m]. `open`: what of each wetted surface lies in no wedge
/// next to a contact [m2].
[[gnu::always_inline]] inline double
throat_drag(const WettedGrains& grains, const std::array<double, 3>& open, double layer) {
    double drag = 0;
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = grains.radius[k];
        drag += grains.area[k] * stokes * (1 / r - 1 / (r + layer)) + open[k] * film / layer;
    }
    return drag;
}

/// Shares of the grains in the drag; they add up to 1. `to_wall`: from the center of each to the nearest surface of a
/// much larger grain [m], behind which water is slower; what it spares one grain goes to those that have none so near.
[[gnu::always_inline]] inline std::array<double, 3>
drag_shares(const WettedGrains& grains, double layer, const std::array<double, 3>& to_wall) {
    std::array<double, 3> full{}, part{};
    double whole = 0, spared = 0, open = 0;
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
        const double r = grains.radius[k];
        full[k] = grains.area[k] * (stokes / r + film_of_share / layer);
        part[k] = std::min(1.0, to_wall[k] / (r + layer_at_wall * layer));
        whole += full[k];
        spared += full[k] - part[k] * full[k];
        open += part[k] == 1 ? full[k] : 0;
    }
    // Where none is open to take over what the others are spared, nobody is spared anything.
    std::array<double, 3> share{};
#pragma GCC unroll 3
    for (std::size_t k = 0; k < 3; ++k) {
        const double taken_over = part[k] == 1 ? full[k] + spared * full[k] / open : part[k] * full[k];
        share[k] = whole > 0 ? (open > 0 ? taken_over : full[k]) / whole : 1.0 / 3;
    }
    return share;
}

} // namespace suffuse::flow
