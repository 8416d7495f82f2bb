#pragma once
// The paper's findings on erosion from a study that was run with several seeds.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/findings.hpp"

namespace suffuse::study {

/// E1 to E7 at the sweep values of the first sample that was probed or eroded, eroded ones first: of every seed that
/// was run there, combined (combine_seeds). Empty where nothing was probed or eroded.
std::vector<Finding> judge_erosion_by_seed(const std::vector<record::FinishedStage>& stages);

/// One way from the sample to its last erosion: the stages whose passes follow each other.
struct Reading {
    std::string name; ///< of its stages: "strict, then unloaded-strict"
    std::vector<Finding> findings;
};

/// All ways of the first sample that was eroded, in the order of the case, each over all its seeds. Erosions that
/// follow the same one are ways of their own.
std::vector<Reading> judge_readings(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::study
