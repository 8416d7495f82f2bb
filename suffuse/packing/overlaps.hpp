#pragma once
// Overlaps taken away by geometry alone: overlapping pairs are pushed apart, one after another, and so a cloud is
// brought to a density that costs a simulation its gas phase [the family of Jodrey & Tory 1985]. No forces, no time.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"

#include <span>
#include <vector>

namespace suffuse::packing {

inline constexpr int default_rounds = 150; ///< searches for pairs, each followed by up to 12 sweeps over them

/// Moves grains until no pair overlaps. The same bits for the same input; work is in the order of the pairs.
/// @param h cell [m]; @param position changed [m]; @param pulse beats with the rounds @return whether it got there.
bool clear_overlaps(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, int most_rounds = default_rounds,
    const Pulse& pulse = {}
);

/// The same with the first `fixed` grains where they are: pairs among these are not looked at.
bool clear_overlaps_around(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, std::size_t fixed, int most_rounds,
    const Pulse& pulse = {}
);

/// Planes that grains do not cross: one row a grain.
struct Slabs {
    int axis = 2;                            ///< across the planes; the cell is a box
    std::vector<double> low = {}, high = {}; ///< between which each whole grain stays [m]
};

/// The same with every grain between its planes.
bool clear_overlaps_between(
    const Mat3& h, std::span<const double> radius, std::vector<Vec3>& position, const Slabs& slabs, int most_rounds,
    const Pulse& pulse = {}
);

/// Shrinks (or widens) the cell of a world at rest to a porosity, grains with it, and clears the overlaps. Contacts and
/// velocities are forgotten. @return whether no overlap is left; near the densest packings some are.
bool bring_to_porosity(dem::World& world, double porosity, int most_rounds = default_rounds);

/// Brings a cloud in small steps as close together as overlaps clear easily: a little looser than where frictionless
/// grains jam. @return the porosity reached.
double bring_near_touching(dem::World& world);

} // namespace suffuse::packing
