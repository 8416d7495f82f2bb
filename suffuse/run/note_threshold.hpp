#pragma once
// A speed threshold knows no twin: where it takes grains that the probe's twin does not distinguish, the run says so.

#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/run/stage_work.hpp"

#include <string>

namespace suffuse::run {

/// Adds a flaw where an absolute speed decides by grains that the rule on displacement, relative to the twin, does not
/// accept. @param when "pass 2", "i = 0.05"
void note_threshold(
    StageWork& work, const std::string& when, const erosion::DetachSpec& rule, const erosion::ProbeResult& probe
);

} // namespace suffuse::run
