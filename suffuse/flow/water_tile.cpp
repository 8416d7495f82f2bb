#include "suffuse/flow/water_tile.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/constants.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/passage_area.hpp"
#include "suffuse/flow/throat_drag.hpp"
#include "suffuse/flow/throat_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace suffuse::flow {
namespace {

using pores::tile_rows;
using pores::TileRow;

/// Water between surfaces nearer than this share of the layer's thickness rests. Fitted, as the exponents below.
constexpr double resting_gap = 0.8;

/// At least this share of what is wetted drags.
constexpr double least_open = 0.1;

/// The area of a throat that counts: harmonic2 facet^widening / mean^(1 + widening).
constexpr double widening = 0.2;

/// Areas are no less than this share of the facet.
constexpr double least_area = 1e-3, least_void = 1e-9;

constexpr double nearly = 1 - 1e-9;

[[gnu::always_inline]] inline std::array<double, 3> at(const std::array<TileRow, 3>& rows, std::size_t k) {
    return {rows[0][k], rows[1][k], rows[2][k]};
}

[[gnu::always_inline]] inline void set(std::array<TileRow, 3>& rows, std::size_t k, const std::array<double, 3>& to) {
    rows[0][k] = to[0], rows[1][k] = to[1], rows[2][k] = to[2];
}

/// By solid angles. The array is made of its elements: copied as a whole, it would keep loops from being vectorized.
[[gnu::always_inline]] inline ThroatWater
counted_water(const pores::ThroatTile& tile, const pores::ThroatGeometries& of, std::size_t k) {
    const std::array<double, 3> wetted = {of.wetted[0][k], of.wetted[1][k], of.wetted[2][k]};
    return {of.hydraulic_radius[k] * (wetted[0] + wetted[1] + wetted[2]), {tile.radii(k), wetted}};
}

struct alignas(64) Layers {
    TileRow linear, square, cube, water; ///< of their equations
    TileRow thickness;                   ///< [m]

    [[gnu::always_inline]] void set(std::size_t k, const LayerEquation& equation) {
        linear[k] = equation.linear, square[k] = equation.square, cube[k] = equation.cube, water[k] = equation.water;
    }

    [[gnu::always_inline]] [[nodiscard]] LayerEquation equation(std::size_t k) const {
        return {linear[k], square[k], cube[k], water[k]};
    }
};

/// Steps until the last throat needs no further one: more than it needs change none by more than rounding.
[[gnu::always_inline]] inline void find_thickness(double least, Layers& layers) {
    TileRow& h = layers.thickness;
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        h[k] = layers.equation(k).start();
    }
    std::int64_t some_go_on = 1;
    for (int i = 0; i < most_steps && some_go_on != 0; ++i) {
        some_go_on = 0;
#pragma GCC ivdep
        for (std::size_t k = 0; k < tile_rows; ++k) {
            const double step = layers.equation(k).step(h[k]);
            h[k] -= step;
            some_go_on |= LayerEquation::goes_on(step, h[k]) ? 1 : 0;
        }
    }
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        h[k] = std::max(least, layers.equation(k).layer(h[k]));
    }
}

/// Area through which the water of a throat goes [m2], but for the power of how it widens.
struct AreaOfPassage {
    double narrow, widens;
};

[[gnu::always_inline]] inline AreaOfPassage
area_of_passage(const pores::ThroatTile& tile, const pores::ThroatGeometries& of, std::size_t k) {
    const std::array<Vec3, 3> x = tile.centers(k);
    const std::array<double, 3> r = tile.radii(k);
    const Vec3 area = of.area[k];
    const double facet = norm(area), void_area = of.void_area[k];
    Passage passage;
    double sections = 0, overlaps = 0;
#pragma GCC unroll 3
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        passage.radius[a] = r[a];
        const Vec3 ab = x[b] - x[a], ac = x[c] - x[a];
        passage.angle[a] = a < 2 ? arctangent(2 * facet, dot(ab, ac)) : pi - passage.angle[0] - passage.angle[1];
        sections += 0.5 * passage.angle[a] * r[a] * r[a];
        const double length = norm(ab);
        overlaps += length < r[a] + r[b] ? lens_of(r[a], r[b], length).half_section : 0;
    }
    // Where sections counted twice exceed the facet, the network keeps the size of the difference alone.
    const double counted = sections - facet > nearly * void_area ? -void_area : void_area;
    passage.facet = std::max(counted + overlaps, least_void * facet);
    const double below = dot(tile.pore_1[k] - x[0], area) / facet, above = dot(tile.pore_2[k] - x[0], area) / facet;
    const PassageArea found = mean_passage_area(passage, below, above, least_length * std::sqrt(facet));
    const double least = least_area * facet, mean = std::max(found.mean, least);
    const double harmonic = std::max(found.harmonic, least);
    return {harmonic * harmonic / mean, facet / mean};
}

} // namespace

SUFFUSE_CLONES void
measure_water(const pores::ThroatTile& tile, const pores::ThroatGeometries& of, double least_layer, WaterTile& water) {
    Layers layers{};
    alignas(64) std::array<TileRow, 3> length{}, angle{}, touched{};
    alignas(64) TileRow widens{};
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const ThroatEdges edges(tile.centers(k), tile.pore_1[k], tile.pore_2[k]);
        const ThroatWater counted = counted_water(tile, of, k), once = count_overlaps_once(edges, counted);
        set(length, k, edges.length), set(angle, k, edges.angle), set(touched, k, once.grains.area);
        layers.set(k, LayerEquation::of(once.grains, once.volume));
        water.volume[k] = once.volume;
        water.covered_twice[k] = once.volume - std::max(0.0, counted.volume);
    }
    find_thickness(least_layer, layers);
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        ThroatEdges edges;
        edges.length = at(length, k), edges.angle = at(angle, k);
        const WettedGrains grains{tile.radii(k), at(touched, k)};
        const double layer = layers.thickness[k];
        std::array<double, 3> open =
            surface_beyond_wedges(edges, counted_water(tile, of, k).grains, resting_gap * layer);
#pragma GCC unroll 3
        for (std::size_t j = 0; j < 3; ++j) {
            open[j] = std::max(open[j], least_open * grains.area[j]);
        }
        water.drag[k] = throat_drag(grains, open, layer);
    }
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const AreaOfPassage area = area_of_passage(tile, of, k);
        water.passage[k] = area.narrow;
        widens[k] = area.widens;
    }
    for (std::size_t k = 0; k < tile_rows; ++k) {
        water.passage[k] *= std::pow(widens[k], widening);
    }
}

SUFFUSE_CLONES void share_drag(
    const pores::ThroatTile& tile, const pores::ThroatGeometries& of, const std::array<TileRow, 3>& to_wall,
    double least_layer, std::array<TileRow, 3>& share
) {
    Layers layers{};
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        const ThroatWater counted = counted_water(tile, of, k);
        layers.set(k, LayerEquation::of(counted.grains, counted.volume));
    }
    find_thickness(least_layer, layers);
#pragma GCC ivdep
    for (std::size_t k = 0; k < tile_rows; ++k) {
        set(share, k, drag_shares(counted_water(tile, of, k).grains, layers.thickness[k], at(to_wall, k)));
    }
}

} // namespace suffuse::flow
