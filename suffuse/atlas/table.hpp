#pragma once
// The tables of the atlas as text: a line of names, then a line of cells for each row.

#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace suffuse::atlas {

/// The cells of one line by the names of their columns, which may come in any order. What is not there, or is no
/// number, is a CaseError that names the line and the column.
class Cells {
public:
    Cells(const std::vector<std::string_view>& names, const std::vector<std::string_view>& cells, std::size_t line);

    [[nodiscard]] std::string_view text(std::string_view column) const;
    [[nodiscard]] double number(std::string_view column) const;
    [[nodiscard]] std::optional<double> optional(std::string_view column) const; ///< nothing for nan

    [[nodiscard]] std::size_t line() const { return line_; }

private:
    std::map<std::string_view, std::string_view> cells_;
    std::size_t line_;
};

/// @param csv is read, not kept: it must outlive the cells
std::vector<Cells> parse_table(std::string_view csv);

} // namespace suffuse::atlas
