#pragma once
// Tables that give the sizes at fixed percents passing, a soil a line: "sample,d60_mm,d30_mm,d10_mm".

#include "suffuse/gradings/sheet_tables.hpp"

#include <vector>

namespace suffuse::gradings {

/// A table of sizes and percents for each soil; none where the sheet is of another kind. A remark says so.
std::vector<SheetTable> read_percentiles(const Sheet& sheet, Problems& problems);

} // namespace suffuse::gradings
