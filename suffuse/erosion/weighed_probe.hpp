#pragma once
// The mobility of a sample's fines as a step of the procedure: the flow that the probe needs, and which of the
// mobile fines the coarse skeleton lets through.

#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/mobility.hpp"
#include "suffuse/erosion/passage.hpp"

namespace suffuse::erosion {

/// Of the fines under `probe.gravity`, while the gradient rises.
MobilityResult weigh_fines(const dem::World& world, const DetachStageSpec& spec, const Surroundings& around);

/// Enters which of the mobile fines leave. Where they travel that is not known before they do.
void mark_leaving(
    const dem::World& world, const CoarseSkeleton& skeleton, ConstrictionSize size, MobilityResult& mobility
);

/// Rows of the mobile fines.
std::vector<std::uint32_t> mobile_rows(const dem::World& world, const MobilityResult& mobility);

// `do = "detach"` with weight: nothing is removed.

MobilityRamp begin_detach(const dem::World& world, const DetachStageSpec& spec, const Surroundings& around);

/// Bears the next level, as climb() of mobility.hpp. @pre it is not over
void climb(MobilityRamp& ramp, const DetachStageSpec& spec, const Surroundings& around, const WatchRamp& watch = {});

/// What the ramp has found, with what leaves. @param world that it began with
MobilityResult detached(const MobilityRamp& ramp, const dem::World& world, const DetachStageSpec& spec);

} // namespace suffuse::erosion
