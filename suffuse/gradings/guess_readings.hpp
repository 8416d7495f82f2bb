#pragma once
// Commands that may read a sheet whose headings and numbers leave its reading open: of columns that a heading or their
// units call sizes, and of shares that nothing says are something else.

#include "suffuse/gradings/reading_options.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <vector>

namespace suffuse::gradings {

struct GuessedReading {
    ReadingOptions options;
    bool is_unit_open = false; ///< nothing says in which unit the sizes are: tried in mm
};

/// Readings to be tried, the likeliest first; a bounded number of them.
std::vector<GuessedReading> guess_readings(const Sheet& sheet);

} // namespace suffuse::gradings
