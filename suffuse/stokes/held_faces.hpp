#pragma once
// The faces of a staggered grid whose velocity the grains decide: those within a grain, where the water stands still,
// and those in the water with a grain's surface before the next face. There the shear of the water ends at the surface,
// not at the face behind it: for a surface at the share s of the spacing d to the next face a force (1/s - 1) mu u/d2
// more than the grid's own differences hold it back, symmetric and of second order [Gibou2002].

#include "suffuse/stokes/grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::stokes {

/// Held faces normal to one axis, row by row along z.
struct HeldFaces {
    std::vector<std::size_t> row_begin; ///< of row x boxes[1] + y, and the end
    std::vector<std::uint32_t> z;       ///< place in the row
    std::vector<std::uint32_t> grain;   ///< that holds it: the nearest
    std::vector<float> mobility;        ///< velocity times viscosity over force per volume, 0 within a grain [m2]

    [[nodiscard]] std::size_t size() const { return z.size(); }
};

/// For x, y, z. Faces normal to x of box (i, j, k) lie at (i, j + 1/2, k + 1/2) spacings, the others likewise.
std::array<HeldFaces, 3>
find_held_faces(const Grid& grid, std::span<const Vec3> position, std::span<const double> radius);

} // namespace suffuse::stokes
