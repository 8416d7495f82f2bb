#pragma once
// The samples of a run that are not finished, shared out to tasks by their price.

#include "suffuse/base/range.hpp"
#include "suffuse/casefile/case.hpp"
#include "suffuse/plan/plan.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

/// What one call of the program runs, one sample after the other.
struct Task {
    std::vector<std::string> samples; ///< their folders below studies/
    Range seconds;                    ///< wall time by the plan; none where nothing was priced [s]
};

/// A task for each sample that the folder does not hold yet, in the order of the case.
std::vector<Task> list_tasks(const casefile::Case& what, const std::filesystem::path& folder);

/// Gives each task its wall time: its stages by the plan, and what a sample costs in addition.
void price_tasks(std::vector<Task>& tasks, const plan::RunPlan& plan);

/// Neighbors together, as many as take `seconds` by the middle of their prices. Longer ones stay alone.
std::vector<Task> pack_tasks(const std::vector<Task>& tasks, double seconds);

} // namespace suffuse::apps
