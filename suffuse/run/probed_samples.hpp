#pragma once
// What the stages with stress probes of a run found, as the report draws and tells it.

#include "suffuse/report/stress_probes.hpp"
#include "suffuse/run/finished_stage.hpp"

#include <vector>

namespace suffuse::run {

/// Of the first such stages, as many as a figure can show.
std::vector<report::ProbedSample> gather_probed_samples(const std::vector<FinishedStage>& stages);

} // namespace suffuse::run
