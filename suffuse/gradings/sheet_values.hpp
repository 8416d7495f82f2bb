#pragma once
// What a cell says by itself, whatever its column: a number, a size, or nothing.

#include "suffuse/gradings/row_words.hpp"
#include "suffuse/gradings/sheet.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace suffuse::gradings {

/// The text of a cell; empty where the row is shorter.
const std::string& text_at(const SheetRow& row, std::size_t column);

/// Its place; that of the row where it is shorter.
Place place_at(const SheetRow& row, std::size_t column);

/// Whether a cell says that nothing was measured: empty, or a dash.
bool is_blank(std::string_view text);

/// Whether a comma in a number is a decimal one: where none separates columns.
bool commas_are_decimal(const Sheet& sheet);

/// A size in the cell, of a notation that needs no scale or as a plain number.
bool is_size(const Sheet& sheet, const SheetRow& row, std::size_t column);

/// The number of a share or mass, without % or unit.
std::optional<double> number_at(const Sheet& sheet, const SheetRow& row, std::size_t column);

} // namespace suffuse::gradings
