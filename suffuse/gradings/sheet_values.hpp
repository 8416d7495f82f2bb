#pragma once
// What a cell or a row says by itself, whatever its column: a number, a size, nothing; and what stands in place of a
// size: a pan or a total, or a word of what the size bounds, as in "< 0.063", "> 63", "passing No. 200" and "63
// - 31.5".

#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sieve_size.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::gradings {

/// What a row is that is no sieve, by the words in place of its size.
enum class RowWord { None, Pan, Total };

/// The pan holds what passed the finest sieve; so does what was washed away.
RowWord read_row_word(std::string_view text);

/// Which grains a cell of sizes speaks of.
enum class SizeSense {
    At,      ///< 0.063: of the sieve itself
    Finer,   ///< < 0.063, passing No. 200, 0 - 0.063
    Coarser, ///< > 63, retained on No. 4
    Class,   ///< 63 - 31.5: between two sieves, of which the finer keeps them
};

struct SizeText {
    std::string text; ///< of the size alone
    SizeSense sense = SizeSense::At;
    std::string upper = {}; ///< of a class, its coarser bound
};

SizeText split_size_text(std::string_view text);

/// The text of a cell; empty where the row is shorter.
const std::string& text_at(const SheetRow& row, std::size_t column);

/// Its place; that of the row where it is shorter.
Place place_at(const SheetRow& row, std::size_t column);

/// The cell; an empty one at the row's place where the row is shorter.
SheetCell cell_at(const SheetRow& row, std::size_t column);

/// The text of the first cell that is not blank; empty where all are.
const std::string& first_text(const SheetRow& row);

/// Whether a cell is a number and nothing else.
bool has_number(const SheetRow& row);

/// The rows that are no comments, from `first` to before `end`.
std::vector<const SheetRow*> value_rows(const Sheet& sheet, std::size_t first, std::size_t end = std::string::npos);

/// Cells of the longest one.
std::size_t width_of(const std::vector<const SheetRow*>& rows);

/// A part of a name behind what it has, with a blank between them.
void append_word(std::string& name, std::string_view part);

/// Whether a cell says that nothing was measured: empty, or a dash.
bool is_blank(std::string_view text);

/// Whether a comma in a number is a decimal one: where none separates columns.
bool commas_are_decimal(const Sheet& sheet);

/// Likewise in one cell: quotes keep its commas.
bool commas_are_decimal(const Sheet& sheet, const SheetRow& row, std::size_t column);

/// The size in a cell, without the word of what it bounds.
std::optional<SieveSize>
size_at(const Sheet& sheet, const SheetRow& row, std::size_t column, SizeScale scale = SizeScale::Unknown);

/// A size in the cell, of a notation that needs no scale or as a plain number.
bool is_size(const Sheet& sheet, const SheetRow& row, std::size_t column);

/// The number of a share or mass, without % or unit.
std::optional<double> number_at(const Sheet& sheet, const SheetRow& row, std::size_t column);

} // namespace suffuse::gradings
