#pragma once
// From finished stages to what the report shows.

#include "suffuse/casefile/case.hpp"
#include "suffuse/report/page.hpp"
#include "suffuse/run/finished_stage.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::run {

/// What is to be said of a run beside its numbers.
struct RunRemarks {
    std::vector<std::string> warnings, flaws; ///< of its stages
    std::vector<std::string> case_warnings;   ///< of the check of the case
    std::vector<report::Finding> findings;    ///< of the paper; shown where the case follows one
    report::Unfinished unfinished;
};

report::ReportData describe_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::vector<FinishedStage>& stages,
    const nlohmann::json& provenance, RunRemarks remarks
);

} // namespace suffuse::run
