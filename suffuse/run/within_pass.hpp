#pragma once
// A stage that is stopped within a pass: what is saved of the pass, and found again.

#include "suffuse/erosion/pass_under_way.hpp"
#include "suffuse/run/stage_work.hpp"

namespace suffuse::run {

/// Saves `state` of the stage and the pass; with the pass's own world where that has begun.
void save_within_pass(const StageWork& work, const erosion::PassUnderWay& now, nlohmann::json state);

/// What save_within_pass left. Where a stage was stopped between passes, or by a version that saved only there, one
/// that has not begun.
erosion::PassUnderWay pass_under_way(const StageWork& work);

} // namespace suffuse::run
