#pragma once
// A run's plan and what came of it, in plan.json of its folder: how far off the plan was.

#include "suffuse/plan/plan.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace suffuse::plan {

/// Writes plan.json. Where an earlier part of the run left one, stages that it priced keep their price.
void keep_plan(const std::filesystem::path& run, const RunPlan& plan);

/// Shorter stages are files and clocks, not steps [s].
inline constexpr double least_timed = 0.2;

/// A stage that was computed, and what had been expected of it.
struct StageOutcome {
    Range planned_steps, planned_seconds;
    double steps = 0, seconds = 0; ///< taken
};

/// How far off a plan was. An error is |middle of the range / truth - 1| [-].
struct PlanError {
    int stages = 0;                         ///< that took long enough to be timed
    double of_steps = 0, of_seconds = 0;    ///< in the median over the stages
    Range planned_seconds;                  ///< of these stages together
    double seconds = 0, of_all_seconds = 0; ///< that they took, and the error of their sum
};

/// Nothing where no stage took long enough to be timed.
std::optional<PlanError> measure_plan_error(const std::vector<StageOutcome>& outcomes);

/// Puts what the finished stages took into plan.json; those from the cache count for nothing.
/// @return nothing where there is no plan, or nothing to compare
std::optional<PlanError> record_outcome(const std::filesystem::path& run);

} // namespace suffuse::plan
