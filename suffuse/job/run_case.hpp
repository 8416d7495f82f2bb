#pragma once
// A case from beginning to end: its samples, summary.json, figures, the report and the sums of it all. Running again in
// the same folder goes on where it stopped, to the same bits.

#include "suffuse/casefile/case.hpp"
#include "suffuse/record/run_outcome.hpp"
#include "suffuse/run/run_options.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::job {

// NOLINTNEXTLINE(bugprone-exception-escape): JSON moves without throwing, which clang-tidy does not see
struct RunReport {
    record::Outcome outcome = record::Outcome::Done;
    std::vector<record::FailedSample> failures;
    std::filesystem::path report; ///< report.html
    std::vector<std::string> warnings, flaws;
    nlohmann::json findings;          ///< as in summary.json; empty where the case follows no paper
    std::vector<std::string> remarks; ///< on what was found damaged and made anew, or could not be checked
};

/// Runs a case. Stages that the folder already holds, for the same resolved case, are taken once they are seen to be as
/// they ended; a run that has ended, and is as it was then, is left alone. Samples run side by side, as many as there
/// are threads; results do not depend on how many.
/// @throws CaseError where the folder holds another case, IoError where it cannot be written, or a file is damaged.
RunReport run_case(const casefile::Case& what, const run::RunOptions& options);

/// The samples of a case without a report, for a caller that reads them itself. Samples that fail are kept as failed.
/// @return false where it was stopped, or its time is over
bool run_without_report(const casefile::Case& what, const run::RunOptions& options);

/// Writes summary.json, figures and report.html from what the run folder holds, without computing. Where samples were
/// run one by one, this gathers them. The caller has seen that the folder is whole (finished_stages.hpp).
/// @param command that requests it, for the provenance of a run that has none yet
RunReport rebuild_report(
    const std::filesystem::path& folder, const std::filesystem::path& page_folder, const std::string& command
);

} // namespace suffuse::job
