#pragma once
// Columns without names: recognized by numbers that can mean one thing only.

#include "suffuse/gradings/grading_columns.hpp"

#include <optional>

namespace suffuse::gradings {

/// Two columns of numbers, of which one can be the sizes alone; else an error.
std::optional<GradingColumns> find_unnamed_columns(const Sheet& sheet, Problems& problems);

} // namespace suffuse::gradings
