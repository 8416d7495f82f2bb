#pragma once
// What a case will cost before it is run: steps, time, memory and disk of every stage, always as a range; time is
// priced by measure_speed.

#include "suffuse/base/range.hpp"
#include "suffuse/casefile/case.hpp"
#include "suffuse/plan/machine_speed.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::plan {

struct StageEstimate {
    std::string study; ///< folder of the variant, as in Progress
    std::string stage, verb;
    std::int64_t grains = 0; ///< at most: what erosion takes is not known beforehand
    Range steps;
    Range seconds;                       ///< wall time [s]
    double memory = 0;                   ///< while it runs, beyond the process itself [B]
    double disk = 0;                     ///< that it leaves [B]
    std::string basis;                   ///< where the steps come from, in words
    std::string kind;                    ///< what stages of one price have in common: "compact: wide, frictional"
    double tables_steps = 0;             ///< in the middle, before past runs of this machine correct it
    double tables_seconds = 0;           ///< [s]
    std::int64_t coarse = 0;             ///< of `grains`, where the stage draws them
    std::optional<double> fines_content; ///< that the sample really has, by mass, where the stage draws it [-]
    std::string sized_by;                ///< the rule of `sample_size` that decided; empty: `particles`
    bool is_done = false;                ///< the run folder holds it
    bool is_cached = false;              ///< the cache holds it
};

/// Samples that `refine` will add when the others have been run: their results decide which, and how many.
struct RefinedEstimate {
    Range samples; ///< how many
    Range seconds; ///< wall time of one of them [s]
};

struct RunPlan {
    MachineSpeed speed;
    std::vector<StageEstimate> stages; ///< in the order in which they run
    RefinedEstimate refined;           ///< in addition to these stages
    int studies = 0;
    Range steps;
    Range seconds;     ///< wall time, `speed.at_once` samples side by side, those that refine adds among them [s]
    double memory = 0; ///< of the greediest stages that can run at once, the process included [B]
    double disk = 0;   ///< of all stages [B]
};

/// Samples of the case that run side by side: as many as there are, or as there are threads.
int samples_at_once(const casefile::Case& what);

/// How long stages take when each sample's run one after the other, and `at_once` samples side by side: their sum,
/// shared, but no less than the longest sample [s].
Range side_by_side(const std::vector<StageEstimate>& stages, int at_once);

/// What `refine` may add to the case: values on either side of the extreme of each curve, or on one side where curves
/// agree and end there, each as dear as some sample of its study.
RefinedEstimate price_refined(const RunPlan& plan, const casefile::Case& what);

/// Wall time of samples that were refined, `at_once` of them side by side [s].
Range seconds_of_refined(const RefinedEstimate& refined, int at_once);

/// The most grains that a stage of the case holds. @throws as plan_run.
std::int64_t largest_sample(const casefile::Case& what);

/// @throws IoError, CaseError where a packing cannot be read or a soil cannot be sampled.
RunPlan plan_run(const casefile::Case& what, const MachineSpeed& speed);

/// Takes out of the plan what needs no computing: stages that the folder of the run holds (empty: there is none yet),
/// and those that the cache holds.
void leave_out_done(
    RunPlan& plan, const casefile::Case& what, const std::filesystem::path& folder, const record::StageCache& cache
);

/// Sums up the plan's stages again.
void sum_up(RunPlan& plan);

void to_json(nlohmann::json& json, const RunPlan& plan);

/// What the case will cost with the threads that were set, priced by a measurement.
/// @param at_once samples that run side by side
RunPlan plan_case(const casefile::Case& what, int at_once);

/// "2 studies, 12 stages, 2.1e6 steps: 3-5 min, 410 MB memory, 180 MB disk".
std::string plan_sentence(const RunPlan& plan);

} // namespace suffuse::plan
