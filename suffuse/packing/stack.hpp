#pragma once
// A cloud of layers: soils one after the other along an axis, none reaching into another, periodic in all directions.
// Grains of each layer are placed at random, pushed apart between two planes, and brought together with the cell. So
// the compaction that follows has little left to do, and grains mix no further than the roughness of the interface.

#include "suffuse/base/pulse.hpp"
#include "suffuse/grains/soil.hpp"
#include "suffuse/packing/seed.hpp"
#include "suffuse/packing/spec.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::packing {

/// Of a settled layer: how much solid its thickness stands for [-].
inline constexpr double layer_porosity = 0.40;

/// A layer, and a cell across layers, has at least so many of its largest grains [-].
inline constexpr double thinnest_layer = 3;

/// A layer as it is drawn.
struct LayerSample {
    grains::SampledGrains grains;
    double solid = 0; ///< volume of them [m3]
};

/// Solid volume of a layer [m3].
double solid_of(const Layer& layer, double width);

/// As many grains of the soil as make the solid volume [m3], within half a mean grain.
/// @throws CaseError where so few grains cannot follow the soil's curve
LayerSample sample_layer(const grains::Soil& soil, double solid, const Pulse& pulse = {});

/// Diameter of the largest grain of a sample [m].
double largest_of(const LayerSample& layer);

/// Grains of the first layer are fine: the base. Those of the others are not. The cell is a box whose edges are those
/// of the settled layers, larger by what the porosity of the cloud requires; layers begin at its origin.
/// @param layers a row a layer of `spec`; the same bits for the same `seed`. @throws CaseError where overlaps remain
Cloud make_stack(
    std::span<const LayerSample> layers, const PackSpec& spec, double density, std::uint64_t seed,
    const Pulse& pulse = {}
);

} // namespace suffuse::packing
