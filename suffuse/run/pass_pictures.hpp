#pragma once
// Pictures between the passes of an erosion, which show what is to come: which grains leave, and in which pass.

#include "suffuse/erosion/result.hpp"
#include "suffuse/run/stage_work.hpp"

namespace suffuse::run {

/// Writes pass-0 (before the first pass), pass-1 and so on, in the formats of the case; the state after the
/// last pass is the stage's own. Further columns: `leaves_in_pass` (0: stays), what the probe of the coming pass saw of
/// the fines, or the gradient that moves them against their weight.
void write_pass_pictures(const StageWork& work, const erosion::ErosionResult& result);

} // namespace suffuse::run
