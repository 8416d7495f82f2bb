#pragma once
// One run folder gathered from what tasks have left.

#include "apps/console.hpp"
#include <filesystem>
#include <string>

namespace suffuse::apps {

/// @param command as typed. @return the exit code
int collect_tasks(const std::filesystem::path& folder, const std::string& command, const Console& console);

} // namespace suffuse::apps
