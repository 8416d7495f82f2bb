#pragma once
// The options of a run, and what it reports while it runs.

#include "suffuse/erosion/own_rule.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <string>

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
    std::string sample; ///< run this one alone (its folder below studies/), at the same time as other programs that run
                        ///< the others; what they leave is gathered by rebuild_report. Empty: all samples
    double time_limit =
        std::numeric_limits<double>::infinity();      ///< wall seconds after which the state is saved and the run stops
    const std::atomic<bool>* stop = nullptr;          ///< set by a signal handler: save and stop at the next burst
    std::function<void(const Progress&)> on_progress; ///< called by the threads of the samples, one at a time
    double progress_interval = 0.1; ///< wall seconds between two bursts of a stage that are reported; 0: every burst is
    int at_once = 0;                ///< samples side by side, at most; 0: as many as there are threads
    std::filesystem::path cache;    ///< of finished stages (stage_cache.hpp); empty: none
    record::Owners cache_owners = record::Owners::Self; ///< whose entries are taken from it
    std::map<std::string, erosion::OwnRule> rules;      ///< of detachment, by "STUDY/STAGE"; such stages know no cache
    std::filesystem::path page_folder;                  ///< the built page of the report; empty: plain report
    std::string case_text;                              ///< the case file as given, copied into the folder
    std::string command;                                ///< as typed, for the provenance
    bool is_checked = false; ///< the caller has seen that the folder is whole, and has not ended
};

} // namespace suffuse::run
