#pragma once
// The paper's findings on erosion from a study that was run with several seeds.

#include "suffuse/report/findings.hpp"
#include "suffuse/run/finished_stage.hpp"

namespace suffuse::run {

/// E1 to E7 at the sweep values of the first sample that was probed or eroded, eroded ones first: of every seed that
/// was run there, combined (report::combine_seeds). Empty where nothing was probed or eroded.
std::vector<report::Finding> judge_erosion_by_seed(const std::vector<FinishedStage>& stages);

} // namespace suffuse::run
