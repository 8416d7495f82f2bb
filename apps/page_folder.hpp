#pragma once

#include <filesystem>

namespace suffuse::apps {

/// Where tools/bootstrap.sh lets npm put the report's page: seen from the program, build/release/apps/suffuse. Empty
/// where it is not there.
std::filesystem::path page_folder();

} // namespace suffuse::apps
