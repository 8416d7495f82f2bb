#pragma once
// Columns without names: recognized by numbers that can mean one thing only.

#include "suffuse/gradings/grading_columns.hpp"

#include <cstddef>
#include <optional>

namespace suffuse::gradings {

/// Whether a column holds numbers from 0 to 100 that rise, or fall, with the size throughout.
bool is_cumulative(const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t share);

/// Two columns of numbers, of which one can be the sizes alone; else an error.
std::optional<GradingColumns> find_unnamed_columns(const Sheet& sheet, Problems& problems);

} // namespace suffuse::gradings
