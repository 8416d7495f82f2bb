#pragma once
// Columns whose headings say nothing next to ones that were found to hold shares: a soil in which a cell is wrong, or
// numbers of the rows.

#include "suffuse/gradings/column_content.hpp"
#include "suffuse/gradings/grading_columns.hpp"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace suffuse::gradings {

/// "Nr." or no heading above 1, 2, 3.
bool is_index(const Sheet& sheet, std::size_t first_row, std::size_t column, std::string_view heading);

struct OddSoils {
    ShareMeaning meaning = ShareMeaning::Passing; ///< finer or coarser, as of the others
    std::vector<std::size_t> columns;
};

/// Columns that would be soils of cumulative shares but for some cells: they are, and these cells are errors.
/// @param columns of the candidates those that hold shares
OddSoils find_soils_with_odd_cells(
    const Sheet& sheet, std::size_t first_row, const SizeColumn& size, const std::vector<std::size_t>& candidates,
    const std::vector<std::pair<std::size_t, Amounts>>& columns
);

} // namespace suffuse::gradings
