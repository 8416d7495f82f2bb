#pragma once
// The end of a run: summary.json, figures and report, made from what the stages left in the folder.

#include "suffuse/casefile/case.hpp"
#include "suffuse/record/run_outcome.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::job {

struct Summary {
    std::filesystem::path report;     ///< report.html
    std::vector<std::string> figures; ///< names of files in figures/
    std::vector<std::string> warnings, flaws;
    nlohmann::json findings; ///< of the paper that the case follows; empty where it follows none
    std::vector<record::FailedSample> failures;
};

/// Reads the finished stages of `folder`, writes summary.json, figures/ and report.html.
Summary summarize_run(
    const casefile::Case& what, const std::filesystem::path& folder, const std::filesystem::path& page_folder
);

} // namespace suffuse::job
