#pragma once
// The paper's findings on erosion from a study that was run with several seeds.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/findings.hpp"

namespace suffuse::study {

/// E1 to E7 at the sweep values of the first sample that was probed or eroded, eroded ones first: of every seed that
/// was run there, combined (report::combine_seeds). Empty where nothing was probed or eroded.
std::vector<Finding> judge_erosion_by_seed(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::study
