#pragma once
// SHA256SUMS of a run folder: every file of the results, and what became of them. What the stages left has the
// checksums that it got when its stage ended, so that nothing damaged is ever signed. What goes on changing is left
// out: the log of events, the progress, what tasks say, the working files of stages under way, hidden files. A stage
// that failed has a checksum of failed.json alone: what else it left may be half of a file.

#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/sums.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::record {

/// As they were when the run ended; none where it has not. @throws IoError where they are damaged
Sums read_run_sums(const std::filesystem::path& run);

/// Writes them.
/// Files of the user, which the program did not write, get none.
/// @param figures names of those that the report has; what else lies next to them is not the run's
/// @param earlier of the run; a stage that has no checksums of its own keeps these
/// @throws IoError
void write_run_sums(const std::filesystem::path& run, const std::vector<std::string>& figures, const Sums& earlier);

/// That the files which say what to compute are as they were when the run ended. @throws IoError
void require_same_inputs(const std::filesystem::path& run);

/// That a file which the report wrote is as it was then. @param name below the run folder @throws IoError
void require_same_result(const std::filesystem::path& run, const std::string& name);

/// The same of figures. @param ids none: all of them @param endings of their files that are to be read
void require_same_figures(
    const std::filesystem::path& run, const std::vector<std::string>& ids, const std::vector<std::string>& endings
);

/// Whether every file but the stages' is as it was when the run ended.
bool has_same_results(const std::filesystem::path& run);

/// What was found in a run, or in a calibration.
struct Verification {
    int files = 0;                              ///< checked
    int states = 0;                             ///< read, and hashed anew
    int stages = 0;                             ///< finished
    std::vector<std::string> without_checksums; ///< those of them that have no checksums of their own
    std::vector<std::string> unverified;        ///< those whose key cannot be compared: perhaps of another case
    std::vector<Damage> damages;
    std::vector<std::string> more; ///< files that came after the checksums, or that an unfinished stage left
    MissingStages missing;         ///< stages that the case has and the folder has not
    std::string until;             ///< the stage that the run was to end with, where it did; else empty
};

/// Checks every file against its checksum and that of its stage, and every state against the hash in its stage.json.
/// @throws IoError where the folder is no run, or its run was interrupted
Verification verify_run(const std::filesystem::path& run);

void to_json(nlohmann::json& json, const Verification& found);

} // namespace suffuse::record
