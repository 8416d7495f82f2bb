#pragma once
// What the columns of a table of grains are where no heading says: x y z r, perhaps behind a number that counts the
// rows, or MFIX's x y z phase diameter density. Where two readings are possible the file is refused.
// [MFIX user guide, particle_input.dat]

#include "suffuse/io/packing_columns.hpp"

namespace suffuse::io {

constexpr std::string_view unnamed_column = "..."; ///< behind those that are known

/// The fields of a row; a blank for `mark` stands for any number of blanks and tabs.
Names split_row(std::string_view line, char mark);

/// Whether a row consists of numbers, or begins with three of them: it is a grain, not a heading.
bool is_row_of_numbers(const Names& fields);

/// A name for each column, and what is to be said of how they were found.
struct HeadlessColumns {
    Names names;
    std::string remark = {}; ///< empty for x y z r
};

/// Of a table whose first row the reader is at.
/// @throws CaseError with file and line.
HeadlessColumns name_columns(const LineReader& reader, const PackingSource& source, const Names& first, char mark);

} // namespace suffuse::io
