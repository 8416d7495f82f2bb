#pragma once
// The cells of a table with their places: columns between commas, semicolons, tabs, bars or blanks; quotes, comments.
// Nothing here knows what the cells mean.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/io/text_file.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::gradings {

using io::trimmed;

struct SheetCell {
    std::string text; ///< without blanks and quotes around it
    Place place;
    bool is_quoted = false;
};

struct SheetRow {
    std::vector<SheetCell> cells;
    Place place;
    bool is_comment = false; ///< a line that begins with #: it may hold the names of the columns
};

struct Sheet {
    std::vector<SheetRow> rows; ///< those that hold something
    char mark = ',';            ///< between columns; a blank stands for any run of blanks, wide_blanks for two and more
};

/// The mark of columns between runs of two blanks and more, where single ones stand within cells.
constexpr char wide_blanks = '\v';

/// The cells between these marks. `#` begins a comment at the start of a line and, further on, behind a value or in a
/// cell of its own: #200 is a sieve, #N/A an error of a spreadsheet. Empty cells at the end of a row, where
/// spreadsheets leave some, are dropped.
Sheet split_sheet(const std::shared_ptr<const Source>& source, char mark);

/// Gives each row of a block of lines the columns of its longest ones, by where the cells stand. Rows of one cell, and
/// those whose cells fit no columns, stay as they are.
void align_rows(Sheet& sheet);

/// The marks of ; tab | and comma that stand outside of quotes and comments, in this order; then wide
/// blanks where there are some, and last the blank.
std::vector<char> possible_marks(std::string_view text);

} // namespace suffuse::gradings
