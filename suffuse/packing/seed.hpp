#pragma once
// A cloud: grains of a sample placed at random in a periodic cube of the specified porosity, none overlapping. Grains
// are added at random, largest first; this saturates near a solid fraction of 0.38 for equal spheres, so that grains
// without a free place go where they overlap least, and overlaps are then pushed apart.

#include "suffuse/base/pulse.hpp"
#include "suffuse/cell/cell.hpp"
#include "suffuse/grains/grains.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/packing/spec.hpp"

#include <cstdint>

namespace suffuse::packing {

struct Cloud {
    cell::Cell cell;
    grains::Grains grains; ///< largest first, at rest, inside the cell
};

/// The cloud of `sample` at the porosity of `spec`, for grains of `density` [kg/m3]; the same bits for the same `seed`.
/// Throws CaseError where the cell would be narrower than two of the largest grains, or where overlaps remain; it then
/// says which number of grains, or which porosity, would do. The pulse beats with the grains placed ("scatter"), then
/// with the rounds of pushing apart ("part").
Cloud make_cloud(
    const grains::SampledGrains& sample, const PackSpec& spec, double density, std::uint64_t seed,
    const Pulse& pulse = {}
);

} // namespace suffuse::packing
