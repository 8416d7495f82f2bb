#pragma once
// Step 5 where grains travel: the detached fines follow the water; those that get far enough leave, those that are held
// lodge, where they stand in the way of the next.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// What became of a grain that the water took along. @param leaves nothing held it  @param place where it finds room,
/// if it was held  @param position where it lay before, [m]  @param radius its own, [m]: a place within a thousandth of
/// it is where it lay before
Fate fate_of(bool leaves, const std::optional<Vec3>& place, const Vec3& position, double radius);

/// Lets the grains of `detached` travel through the pores between all others, and puts those that are held where they
/// are held. How far each has come counts from the first pass on; how each fared is in `pass.transport`.
/// @return rows of the grains that left, which still are in the world
/// @throws StateError for a distance of more than a thousand cells
std::vector<std::uint32_t> transport_fines(
    dem::World& world, std::span<const std::uint32_t> detached, const ErodeSpec& spec, const flow::Fluid& fluid,
    const ErosionResult& so_far, PassResult& pass
);

} // namespace suffuse::erosion
