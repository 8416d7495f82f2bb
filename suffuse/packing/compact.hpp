#pragma once
// Isotropic compaction of a cloud to a pressure, as the reference does it (its section 4): under a lowered friction or
// with adhesion, strain rate capped in three steps as the load builds up; then the final parameters, and settling.

#include "suffuse/dem/settle.hpp"
#include "suffuse/packing/spec.hpp"

#include <cstdint>

namespace suffuse::packing {

/// Where a compaction stands; part of what a checkpoint saves.
struct CompactState {
    enum class Phase : std::int32_t { Compact, Settle, Done };

    Phase phase = Phase::Compact;
    dem::BalanceState balance;
    double time_step = 0;            ///< of the bursts now [s]
    grains::Material material;       ///< with the final parameters
    double damping = 0.2;            ///< local [-]
    std::int64_t steps = 0;          ///< in all
    double void_ratio_compacted = 0; ///< at the end of compaction, before the final parameters
};

/// Sets the parameters of the compaction; `world` is the cloud.
CompactState begin_compaction(dem::World& world, const CompactSpec& spec, double damping);

/// One burst of steps. @return whether the sample is settled at the pressure with its final parameters.
/// @throws StateError when the pressure is out of reach, with the void ratio and the pressure reached.
bool compact_burst(
    dem::World& world, dem::StepCaches& caches, const CompactSpec& spec, const dem::BalanceSpec& balance,
    CompactState& state
);

} // namespace suffuse::packing
