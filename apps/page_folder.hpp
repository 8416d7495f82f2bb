#pragma once

#include <filesystem>

namespace suffuse::apps {

/// The report's page, seen from the program: where tools/bootstrap.sh lets npm put it for build/release/apps/suffuse,
/// or PREFIX/share/suffuse/report-page for PREFIX/bin/suffuse. Empty where it is not there.
std::filesystem::path page_folder();

} // namespace suffuse::apps
