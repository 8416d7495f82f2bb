#pragma once
// What a machine lacks for a run, told before the run is started.

#include "suffuse/plan/plan.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::apps {

/// A sentence each for memory and for disk, where the plan may need more than there is.
/// @param folder that holds the run, or will
std::vector<std::string> shortages(const plan::RunPlan& plan, const std::filesystem::path& folder);

} // namespace suffuse::apps
