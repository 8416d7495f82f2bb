#pragma once
// What shows whether a filter holds its base: sizes of both, the filter's controlling constriction, a cut through the
// stack before and after, and which sizes of the base entered and left.

#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/erosion/stack.hpp"

namespace suffuse::erosion {

/// The state before the flow. The controlling constriction is the diameter of the largest sphere that finds a way
/// through all of the filter, all of the base taken away [Kenney et al. 1985]: of the widest
/// path that leads through the pores of its grains.
/// @param base_gap see MigrateSpec
FilterView view_filter(
    const dem::World& world, const Stack& stack, const Vec3& direction, const std::optional<double>& base_gap = {}
);

/// Enters what is there now. @param world without the grains that left
void look_again(
    const MigrationLedger& ledger, const dem::World& world, const Stack& stack, const Vec3& direction, FilterView& view
);

/// Circles in which the plane along the flow through the middle of the cell cuts the grains.
StackCut cut_stack(const dem::World& world, const Stack& stack, const Vec3& direction);

} // namespace suffuse::erosion
