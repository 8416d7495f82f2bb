#pragma once
// Tables whose sieves stand across, a sample a row: "Sample,75 mm,37.5 mm,19 mm" or "Boring,#4,#10,#40,#200". They are
// turned, so that a line is a sieve as in all others.

#include "suffuse/gradings/sheet_tables.hpp"

#include <optional>

namespace suffuse::gradings {

/// Empty where the sieves stand below each other. A remark says that they are turned.
std::optional<SheetTable> turn_table(const Sheet& sheet, Problems& problems);

} // namespace suffuse::gradings
