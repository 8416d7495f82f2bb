#pragma once
// The mobility of a sample's fines as a step of the procedure: the flow that the probe needs, and which of the
// mobile fines the coarse skeleton lets through.

#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/mobility.hpp"
#include "suffuse/erosion/passage.hpp"

namespace suffuse::erosion {

/// Of the fines under `probe.gravity`, while the gradient rises through `gradients`.
/// @param specified the gradient that the soil has to bear, if any @param watch sees the ramp as it goes
MobilityResult weigh_fines(
    const dem::World& world, std::vector<double> gradients, std::optional<double> specified, const Vec3& direction,
    const ProbeSpec& probe, const Surroundings& around, const WatchRamp& watch = {}
);

/// Enters which of the mobile fines leave. Where they travel that is not known before they do.
void mark_leaving(
    const dem::World& world, const CoarseSkeleton& skeleton, ConstrictionSize size, MobilityResult& mobility
);

/// Rows of the mobile fines.
std::vector<std::uint32_t> mobile_rows(const dem::World& world, const MobilityResult& mobility);

/// `do = "detach"` with weight: nothing is removed.
MobilityResult probe_mobility(
    const dem::World& world, const DetachStageSpec& spec, const Surroundings& around, const WatchRamp& watch = {}
);

} // namespace suffuse::erosion
