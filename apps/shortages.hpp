#pragma once
// What a disk lacks for a run, reported before the run is started; memory is a bound (plan/fit_memory.hpp).

#include "suffuse/plan/plan.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

/// A sentence where the plan may need more disk than there is.
/// @param folder that holds the run, or will
std::vector<std::string> shortages(const plan::RunPlan& plan, const std::filesystem::path& folder);

} // namespace suffuse::apps
