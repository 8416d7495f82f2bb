#pragma once
// Which fines a gradient moves against their weight. On a copy of the sample the coarse grains are held, and with them
// the fines that carry the skeleton's forces; the other fines fall into place under their weight, and then bear a
// gradient that rises step by step, each held until nothing new moves. The sample itself stays weightless: the soil
// around a representative cell carries its skeleton, so that no floor is needed (docs/theory/weight.md).

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/mobility_result.hpp"
#include "suffuse/erosion/ramp.hpp"
#include "suffuse/erosion/refined_ramp.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/erosion/weight.hpp"
#include "suffuse/flow/fluid.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::erosion {

/// What is known of the water at one moment: the force on each grain at a hydraulic gradient of 1, without buoyancy.
struct UnitSeepage {
    std::vector<Vec3> force; ///< [N]
    flow::FlowSource source;
    double permeability = 0; ///< along the flow [m2]
};

/// Solves the flow through the copy as it is.
using SolveFlow = std::function<UnitSeepage(const dem::World& world)>;

/// Sees the ramp as it goes: the steps that are kept, and the one that is held, so far.
using WatchRamp = std::function<void(std::span<const MobilityStep> kept, const MobilityStep& held)>;

struct MobilitySetting {
    Gravity gravity;
    flow::Fluid fluid;
    Vec3 direction = {0, 0, 1};
    std::vector<double> gradients; ///< rising, above 0; the ramp is refined between them, see refined_ramp.hpp
    WeighedMotion motion;
    std::optional<double> specified_gradient;
};

/// Fines under a ramp, between two of its levels: all that they go on from, to the same bits.
struct MobilityRamp {
    dem::World world; ///< as the last level that was kept has left it; what is held carries the skeleton
    WeightScale scale;
    MobilityResult result;            ///< so far
    std::vector<double> tried;        ///< mobile share of the mass at each level so far, undone ones too
    std::vector<Vec3> rest;           ///< of the fines, before the water pulled
    std::vector<Vec3> solved_at;      ///< of the fines, where the flow was solved that pulls
    std::optional<UnitSeepage> water; ///< that flow; nothing: it is solved anew
    bool over = false;                ///< all gradients were borne
};

/// Lays the fines to rest under their weight.
/// @throws CaseError, StateError for a setting or sample that cannot be; and what `solve` throws
MobilityRamp begin_ramp(
    const dem::World& equilibrium, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse = {}
);

/// Bears the next level. A pulse that throws leaves the ramp as it was before the call. @pre it is not over
void climb(
    MobilityRamp& ramp, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse = {},
    const WatchRamp& watch = {}
);

/// The whole ramp. @throws as begin_ramp
MobilityResult find_mobility(
    const dem::World& equilibrium, const MobilitySetting& setting, const SolveFlow& solve, const Pulse& pulse = {},
    const WatchRamp& watch = {}
);

/// Enters which of the mobile fines also leave. @param passes a row a fine grain of the result
void mark_leaving(MobilityResult& mobility, std::span<const std::uint8_t> passes);

} // namespace suffuse::erosion
