#pragma once
// Columns whose headings say nothing next to ones that were found to hold shares: a soil in which a cell is wrong, or
// numbers of the rows.

#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/grading_columns.hpp"

#include <string_view>

namespace suffuse::gradings {

/// "Nr." or no heading above 1, 2, 3.
bool is_index(const Sheet& sheet, std::size_t first_row, std::size_t column, std::string_view heading);

/// Whether a column would be a soil of cumulative shares but for some cells: it is one, and these are errors.
/// @param meaning of the others: finer, or coarser
bool is_soil_but_for_cells(
    const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t column, ShareMeaning meaning
);

} // namespace suffuse::gradings
