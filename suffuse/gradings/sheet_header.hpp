#pragma once
// The row of a sheet that names its columns, and a row of units below it.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace suffuse::gradings {

struct SheetHeader {
    std::size_t row = 0;
    std::size_t lines = 1; ///< headings may go on in the next row: "Sieve" above "(mm)"
    std::vector<Heading> headings;
    bool is_complete = false; ///< a size and a share
};

/// The first complete row of headings, else the first with a size; a comment counts where no other line does.
std::optional<SheetHeader> find_sheet_header(const Sheet& sheet);

/// The columns of a kind, rising.
std::vector<std::size_t> columns_of_kind(const std::vector<Heading>& headings, ColumnKind kind);

/// Whether a row names a size and a share.
bool is_complete_header(const SheetRow& row);

/// "mm,%": a row without a number, in which every cell is a unit. @return whether it is one, and was taken
bool take_unit_row(const SheetRow& row, std::vector<Heading>& headings);

/// More columns than a table of gradings has, which is reported.
bool is_too_wide(const Sheet& sheet, Problems& problems);

/// Rows that are looked through for headings.
constexpr std::size_t most_titles = 60;

} // namespace suffuse::gradings
