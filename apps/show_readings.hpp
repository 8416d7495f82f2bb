#pragma once
// suffuse assess --show-reading: how each file is read, and nothing judged.

#include "suffuse/gradings/reading_options.hpp"

#include "apps/console.hpp"
#include <string>
#include <vector>

namespace suffuse::apps {

/// @param sample of files that hold several; empty: all. @return the exit code
int show_readings(
    const std::vector<std::string>& files, const std::string& sample, const gradings::ReadingOptions& reading,
    const Console& console
);

} // namespace suffuse::apps
