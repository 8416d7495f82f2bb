#pragma once
// A sample made skeleton first: the coarse grains have been compacted alone, and the fines are put into their voids. As
// long as these hold them, the coarse grains keep the intergranular void ratio that they have without fines. Where they
// do not, the skeleton is widened, evenly, by as much as the fines need, and all are compacted together: at the fines
// content that just fits both are the same.
//
// The fines fit when geometry can place them, none touching, as openly as the cloud of which a compaction makes its
// first step (open_porosity): spheres pushed apart without forces come to a porosity of some 0.38, so that each keeps a
// distance to the next of some 7 % of its size.

#include "suffuse/dem/world.hpp"

#include <cstdint>

namespace suffuse::packing {

/// Takes the fines out of a cloud. @return them, as they were.
grains::Grains take_out_fines(dem::World& world);

struct Placing {
    double widening = 1;     ///< edges of the cell over those of the skeleton alone [-]
    bool touch_none = false; ///< whether every fine grain has room; otherwise the widest cell tried left overlaps
};

/// Puts the fines into the voids of the skeleton, at random and at rest. Contacts of a skeleton that had to be widened
/// are gone; the other grains are not touched. The same bits for the same `world.seed`.
Placing put_into_voids(dem::World& world, const grains::Grains& fines);

} // namespace suffuse::packing
