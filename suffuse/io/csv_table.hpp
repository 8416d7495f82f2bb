#pragma once
// The cells of a table that a spreadsheet wrote, with their places: columns between commas, semicolons or tabs, quotes,
// comments.

#include "suffuse/base/diagnostics.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

struct CsvCell {
    std::string text; ///< without blanks and quotes around it
    Place place;
};

struct CsvRow {
    std::vector<CsvCell> cells;
    Place place;
};

struct CsvTable {
    std::vector<CsvRow> rows; ///< those that hold something
    char mark = ',';          ///< between columns
};

/// Without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// The mark between columns is the first of ; and tab that the header has, else a comma. Empty cells at the end of a
/// line, where spreadsheets leave some, are dropped.
CsvTable split_rows(const std::shared_ptr<const Source>& source);

} // namespace suffuse::io
