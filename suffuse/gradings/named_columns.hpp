#pragma once
// A table of which the user names the columns of sizes and shares: nothing is inferred but units that are not given.

#include "suffuse/gradings/reading_options.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sheet_tables.hpp"

#include <optional>

namespace suffuse::gradings {

/// Code of the remark that the named columns end above the last line.
constexpr const char* columns_end = "W509";

/// The named columns as a table of their own, with the columns of samples next to them. Empty where the sheet has no
/// such column, or the options contradict each other, which is reported.
std::optional<SheetTable> read_named_columns(const Sheet& sheet, const ReadingOptions& options, Problems& problems);

} // namespace suffuse::gradings
