#pragma once
// What the stages with stress probes of a run found, as the report draws and tells it.

#include "suffuse/report/stress_probes.hpp"
#include "suffuse/run/finished_stage.hpp"

#include <vector>

namespace suffuse::run {

/// The mean over the seeds of each such stage at each set of swept values; the first ones, as many as a figure can
/// show.
std::vector<report::ProbedState> gather_probed_states(const std::vector<FinishedStage>& stages);

} // namespace suffuse::run
