#pragma once
// Tables next to each other in the same lines: one soil for each, or one curve that goes on from table to table.

#include "suffuse/gradings/sheet_tables.hpp"

#include <vector>

namespace suffuse::gradings {

/// The tables that are next to each other in one; that itself where there is no second.
std::vector<SheetTable> split_side_by_side(SheetTable table, Problems& problems);

} // namespace suffuse::gradings
