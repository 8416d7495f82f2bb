#pragma once
// From what a run found to what its report shows.

#include "suffuse/report/page.hpp"
#include "suffuse/study/run_results.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::job {

/// What is to be said of a run besides its numbers.
struct RunRemarks {
    std::vector<std::string> warnings, flaws; ///< of its stages
    std::vector<std::string> case_warnings;   ///< of the check of the case
    report::Unfinished unfinished;
};

/// @param folder of the run
report::ReportData describe_run(
    const study::RunResults& results, const std::filesystem::path& folder, const nlohmann::json& provenance,
    RunRemarks remarks
);

/// Fills in what is known of how it was made. @throws IoError where provenance.json of the folder is damaged
void take_provenance(report::ReportData& data, const std::filesystem::path& folder, const nlohmann::json& provenance);

} // namespace suffuse::job
