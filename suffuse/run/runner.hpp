#pragma once
// From a case to a run folder: every study's variants, stage after stage, each stage's numbers and state on disk as
// soon as it is done. Running again in the same folder goes on where it stopped, to the same bits.

#include "suffuse/casefile/case.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace suffuse::run {

/// Where a run is; handed out several times a second.
struct Progress {
    std::string study; ///< folder of the variant
    std::string stage, verb;
    int stage_number = 0, stages = 0; ///< over the whole run, 1-based
    std::string part;                 ///< "relax", "probe", "servo", ...
    long long steps = 0;              ///< of this part
    double stage_seconds = 0, run_seconds = 0;
    double particle_steps_per_second = 0;
    nlohmann::json state; ///< numbers worth showing now: void_ratio, mean_stress, unbalanced_force, ...
    bool stage_finished = false;
};

struct RunOptions {
    std::filesystem::path folder; ///< of the run; made if absent
    std::string until;            ///< stop after this stage (of any study); empty: all
    double time_limit =
        std::numeric_limits<double>::infinity(); ///< wall seconds after which the state is saved and the run stops
    const std::atomic<bool>* stop = nullptr;     ///< set by a signal handler: save and stop at the next burst
    std::function<void(const Progress&)> on_progress;
    std::filesystem::path page_folder; ///< the built page of the report; empty: plain report
    std::string case_text;             ///< the case file as given, copied into the folder
    std::string command;               ///< as typed, for the provenance
};

enum class Outcome {
    Done,
    DoneWithFlaws, ///< ran, but a quality bar was missed; the results say which
    Stopped,       ///< by `stop`
    TimeLimit,
};

struct RunReport {
    Outcome outcome = Outcome::Done;
    std::filesystem::path report; ///< report.html
    std::vector<std::string> warnings, flaws;
    nlohmann::json findings; ///< as in summary.json
};

/// Runs a case. Stages that the folder already holds, for the same resolved case, are taken as they are.
/// @throws Error and its children, with the stage named; what was finished stays in the folder.
RunReport run_case(const casefile::Case& what, const RunOptions& options);

/// Writes summary.json, figures and report.html again from what the run folder holds, without computing.
RunReport rebuild_report(const std::filesystem::path& folder, const std::filesystem::path& page_folder);

} // namespace suffuse::run
