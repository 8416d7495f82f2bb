#pragma once
// Where grains that a constriction holds come to lie: in the first of their places that nobody else fills.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/water_ways.hpp"

#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// For each journey the place that its grain takes, or nothing: it got far enough, or stays where it was. Grains whose
/// journeys ended far enough are gone, all others are in the way. One that finds its places filled tries again when
/// others have moved on.
std::vector<std::optional<Vec3>> find_places(const dem::World& world, std::span<const Journey> journeys);

} // namespace suffuse::erosion
