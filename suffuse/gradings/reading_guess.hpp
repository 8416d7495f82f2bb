#pragma once
// Which columns of a sheet that could not be read may be the sizes and the shares, by their numbers.

#include "suffuse/gradings/reading_options.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <vector>

namespace suffuse::gradings {

/// Readings to be tried, the likeliest first; a bounded number of them.
std::vector<ReadingOptions> guess_readings(const Sheet& sheet);

} // namespace suffuse::gradings
