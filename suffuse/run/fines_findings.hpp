#pragma once
// What the samples of a run say together about fines content and microstructure: the study that sweeps the fines
// content, its loose and dense stage, its thresholds, and the samples that lost their fines at once.

#include "suffuse/report/findings_fines.hpp"
#include "suffuse/report/page_table.hpp"
#include "suffuse/run/report_data.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::run {

struct FinesResults {
    std::string study, loose_stage, dense_stage; ///< names; empty where there is none
    report::StageCurve loose, dense;             ///< without points where there is none
    std::vector<report::ContentThreshold> thresholds;
    std::vector<report::Removal> removals; ///< of all studies of the case
};

/// The study of find_fines_sweep, where it sweeps the fines content over three values at least and nothing else, and
/// its loose and densest stages. Nothing where the run has neither such a study nor removals.
std::optional<FinesResults> gather_fines(const casefile::Case& what, const std::vector<FinishedStage>& stages);

/// M1 to M9; empty without a study.
std::vector<report::Finding> judge_fines_of(const std::optional<FinesResults>& results);

/// As in summary.json: study, stages, and for each threshold `name`, `from`, `of_seed`, `mean`, `standard_deviation`.
nlohmann::json thresholds_json(const std::optional<FinesResults>& results);

/// What the thresholds say, for the report's answer; empty where there are none.
std::string thresholds_sentence(const std::optional<FinesResults>& results);

/// The thresholds as a table of the report; nothing where there are none.
std::optional<report::PageTable> thresholds_table(const std::optional<FinesResults>& results);

} // namespace suffuse::run
