#pragma once
// Step 4 of the procedure: the constrictions of the coarse skeleton, and which grains they let through.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"

#include <optional>
#include <vector>

namespace suffuse::erosion {

/// The coarse grains alone, triangulated.
struct CoarseSkeleton {
    Constrictions constrictions; ///< between voids merged as specified
    ConstrictionsByMerge by_merge;
    std::vector<double> widest_path; ///< diameter of the widest path from where each grain of the world is [m]
};

/// @param with_paths also finds the widest paths along `direction` (the cell axis nearest to it).
/// @throws GeometryError with too few coarse grains to triangulate.
CoarseSkeleton measure_coarse_skeleton(
    const dem::World& world, const Vec3& direction, bool with_paths, pores::VoidMerge merge = pores::VoidMerge::None
);

/// What the coarse skeleton must have, or it has lost its meaning as a filter and erosion ends: a width of the cell in
/// median coarse diameters, below which the skeleton sees its own images, and a number of coarse grains, for a
/// distribution of constrictions to mean anything.
inline constexpr double narrowest_skeleton = 5;
inline constexpr std::size_t fewest_coarse = 50;

/// Whether the coarse skeleton has lost its meaning as a filter; nothing where it has not.
std::optional<SkeletonDoubt> doubt_skeleton(const dem::World& world);

/// Whether a grain of diameter `d` [m] in row `g` passes.
bool passes(const CoarseSkeleton& skeleton, ConstrictionSize size, std::size_t g, double d);

} // namespace suffuse::erosion
