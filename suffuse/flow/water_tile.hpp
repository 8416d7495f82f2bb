#pragma once
// What bounded drag computes of 64 throats side by side (pores/tile.hpp): their water, its drag and how their grains
// share it, and the area through which it goes. docs/theory/pore-flow.md, "Bounded drag".

#include "suffuse/pores/tile.hpp"

#include <array>

namespace suffuse::flow {

struct alignas(64) WaterTile {
    pores::TileRow volume;        ///< overlaps of grains counted once [m3]
    pores::TileRow covered_twice; ///< what they cover twice [m3]
    pores::TileRow drag;          ///< for a viscosity of 1 [m]
    pores::TileRow passage;       ///< area through which the water goes [m2]
};

/// Of `of`: what the network keeps. @param least_layer no water on grains is thinner [m]
void measure_water(
    const pores::ThroatTile& tile, const pores::ThroatGeometries& of, double least_layer, WaterTile& water
);

/// Shares of the three grains of each throat in its drag. @param to_wall from the center of each to the nearest surface
/// of a much larger grain [m]
void share_drag(
    const pores::ThroatTile& tile, const pores::ThroatGeometries& of, const std::array<pores::TileRow, 3>& to_wall,
    double least_layer, std::array<pores::TileRow, 3>& share
);

} // namespace suffuse::flow
