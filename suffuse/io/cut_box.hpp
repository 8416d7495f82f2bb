#pragma once
// A box cut out of a bed between walls: the grains whose centers lie in it become a periodic cell. A grain near a face
// meets the images of grains near the opposite face, which were never its neighbors. Of two grains that overlap across
// a face the smaller one is left out; the others stay as they are.

#include "suffuse/cell/cell.hpp"
#include "suffuse/grains/grains.hpp"

#include <cstddef>
#include <string>

namespace suffuse::io {

/// Edges along the axes. A center on a lower face is inside, one on an upper face is not.
struct Box {
    Vec3 low, high; ///< corners [m]
};

struct CutGrains {
    std::size_t outside = 0; ///< whose centers lie outside of the box
    std::size_t across = 0;  ///< left out for their overlap across a face
};

/// Throws CaseError where a box has no volume.
void check_box(const Box& box);

/// Keeps the grains of the box, with positions from its lower corner and ids from 0.
/// @param max_overlap largest across a face / radius of the smaller grain [-]
/// @throws CaseError where the box has no volume or no grain, or where grains cannot be meant.
CutGrains cut_box(grains::Grains& grains, const Box& box, double max_overlap, const std::string& file);

} // namespace suffuse::io
