#pragma once
// From a case to a run folder: the samples of every study, as many side by side as there are threads, each stage's
// numbers and state on disk as soon as it is done. Running again in the same folder goes on where it stopped, to the
// same bits. A sample that fails is reported and does not stop the others.

#include "suffuse/casefile/case.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::run {

/// Where one sample of a run is, and how much of the run is done; handed out several times a second, one call at a
/// time.
// NOLINTNEXTLINE(bugprone-exception-escape): JSON moves without throwing, which clang-tidy does not see
struct Progress {
    std::string study;           ///< folder of the sample
    int sample = 0, samples = 0; ///< over the whole run, 1-based
    std::string stage, verb;
    int stage_number = 0, stages = 0; ///< over the whole run, 1-based
    std::string part;                 ///< "relax", "probe", "servo", ...
    long long steps = 0;              ///< of this part
    double stage_seconds = 0, run_seconds = 0;
    double particle_steps_per_second = 0;
    nlohmann::json state; ///< numbers worth showing now: void_ratio, mean_stress, unbalanced_force, ...
    bool stage_finished = false;
    bool from_cache = false;   ///< the finished stage was not computed again
    bool sample_ended = false; ///< nothing more will come from this sample
    std::string failure;       ///< why it failed; empty where it did not
    // Of the whole run, what an earlier run in this folder did included.
    int stages_done = 0, samples_done = 0, samples_failed = 0;
};

struct RunOptions {
    std::filesystem::path folder; ///< of the run; made if absent
    std::string until;            ///< each sample ends with its stage of this name; empty: all stages
    std::string sample; ///< run this one alone (its folder below studies/), beside other programs that run the others;
                        ///< what they leave is gathered by rebuild_report. Empty: all samples
    double time_limit =
        std::numeric_limits<double>::infinity();      ///< wall seconds after which the state is saved and the run stops
    const std::atomic<bool>* stop = nullptr;          ///< set by a signal handler: save and stop at the next burst
    std::function<void(const Progress&)> on_progress; ///< called by the threads of the samples, one at a time
    double progress_interval = 0.1; ///< wall seconds between two bursts of a stage that are told of; 0: every burst is
    std::filesystem::path cache;    ///< of finished stages (stage_cache.hpp); empty: none
    std::filesystem::path page_folder; ///< the built page of the report; empty: plain report
    std::string case_text;             ///< the case file as given, copied into the folder
    std::string command;               ///< as typed, for the provenance
    bool is_checked = false;           ///< whoever calls has seen that the folder is whole, and has not ended
};

enum class Outcome {
    Done,
    DoneWithFlaws, ///< ran, but a quality bar was missed; the results say which
    SomeFailed,    ///< the samples in `failures` failed; the others ran
    Stopped,       ///< by `stop`
    TimeLimit,
};

/// "done", "stopped": as events and documents say it.
constexpr std::string_view word_of(Outcome outcome) {
    switch (outcome) {
    case Outcome::Done:
        return "done";
    case Outcome::DoneWithFlaws:
        return "done with flaws";
    case Outcome::SomeFailed:
        return "failed in part";
    case Outcome::Stopped:
        return "stopped";
    case Outcome::TimeLimit:
        break;
    }
    return "time limit reached";
}

/// Whether the run would go on where it was left.
constexpr bool is_resumable(Outcome outcome) {
    return outcome == Outcome::Stopped || outcome == Outcome::TimeLimit;
}

/// A sample that could not be run to its end.
struct FailedSample {
    std::string sample;  ///< its folder below studies/
    std::string stage;   ///< where it failed
    std::string kind;    ///< "run", "case", "io" or "memory"
    std::string message; ///< what went wrong and what to do
};

/// As summary.json and the program's documents list it.
void to_json(nlohmann::json& json, const FailedSample& failure);

// NOLINTNEXTLINE(bugprone-exception-escape): likewise
struct RunReport {
    Outcome outcome = Outcome::Done;
    std::vector<FailedSample> failures;
    std::filesystem::path report; ///< report.html
    std::vector<std::string> warnings, flaws;
    nlohmann::json findings;          ///< as in summary.json; empty where the case follows no paper
    std::vector<std::string> remarks; ///< on what was found damaged and made anew, or could not be checked
};

/// Runs a case. Stages that the folder already holds, for the same resolved case, are taken once they are seen to be as
/// they ended; a run that has ended, and is as it was then, is left alone. Samples run side by side, as many as there
/// are threads; results do not depend on how many.
/// @throws CaseError where the folder holds another case, IoError where it cannot be written, or a file is damaged.
RunReport run_case(const casefile::Case& what, const RunOptions& options);

/// Writes summary.json, figures and report.html from what the run folder holds, without computing. Where samples were
/// run one by one, this gathers them. Whoever calls has seen that the folder is whole (finished_stages.hpp).
/// @param command that asked for it, for the provenance of a run that has none yet
RunReport rebuild_report(
    const std::filesystem::path& folder, const std::filesystem::path& page_folder, const std::string& command
);

} // namespace suffuse::run
