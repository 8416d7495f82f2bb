#pragma once
// What the samples of a run say together about fines content and microstructure: the study that sweeps the fines
// content, its loose and dense stage, its thresholds, and the samples that lost their fines at once.

#include "suffuse/study/findings_fines.hpp"
#include "suffuse/study/fines_sweep.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

struct FinesResults {
    std::string study, loose_stage, dense_stage; ///< names; empty where there is none
    StageCurve loose, dense;                     ///< without points where there is none
    std::vector<ContentThreshold> thresholds;
    std::optional<double> size_ratio; ///< D50 of the coarse grains over that of the fines [-]
    std::vector<Removal> removals;    ///< of all studies of the case
};

/// Of the study of find_fines_sweep, where it sweeps the fines content over three values at least and nothing else, and
/// its loose and densest stages. Nothing where the run has neither such a study nor removals.
std::optional<FinesResults>
gather_fines(const std::optional<FinesSweep>& sweep, const std::vector<record::FinishedStage>& stages);

/// M1 to M9; empty without a study.
std::vector<Finding> judge_fines_of(const std::optional<FinesResults>& results);

/// The thresholds that the figures mark, each with one standard deviation to both sides.
void mark_thresholds(const std::vector<ContentThreshold>& thresholds, FinesStudy& study);

/// As in summary.json: study, stages, and for each threshold `name`, `from`, `of_seed`, `mean`, `standard_deviation`.
nlohmann::json thresholds_json(const std::optional<FinesResults>& results);

} // namespace suffuse::study
