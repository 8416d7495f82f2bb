#pragma once
// How far the base of a stack has come into its filter: profiles of solid along the flow, and depths.

#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/erosion/stack.hpp"

#include <cstddef>

namespace suffuse::erosion {

/// Slices half of the largest filter grain thick, from the interface both ways, over all of the stack; what the filter
/// fills of them, and no base yet.
BaseProfile begin_profile(const dem::World& world, const Stack& stack, const Vec3& direction);

/// Of a base grain from the interface, along the flow: where it is, or was last [m].
double depth_of(const MigrationLedger& ledger, std::size_t k, const Stack& stack, const Vec3& direction);

/// Adds what the base fills now, without what has left; and enters in the hold how far it has come.
void note_profile(
    const MigrationLedger& ledger, const dem::World& world, const Stack& stack, const Vec3& direction,
    BaseProfile& profile, MigrationHold& hold
);

} // namespace suffuse::erosion
