#include "suffuse/gradings/sheet_values.hpp"

#include <algorithm>
#include <cctype>

namespace suffuse::gradings {

bool commas_are_decimal(const Sheet& sheet) {
    return sheet.mark != ',';
}

bool commas_are_decimal(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    return commas_are_decimal(sheet) || (column < row.cells.size() && row.cells[column].is_quoted);
}

std::optional<SieveSize> size_at(const Sheet& sheet, const SheetRow& row, std::size_t column, SizeScale scale) {
    return read_sieve_size(split_size_text(text_at(row, column)).text, scale, commas_are_decimal(sheet));
}

bool is_size(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    return size_at(sheet, row, column).has_value();
}

const std::string& text_at(const SheetRow& row, std::size_t column) {
    static const std::string none;
    return column < row.cells.size() ? row.cells[column].text : none;
}

Place place_at(const SheetRow& row, std::size_t column) {
    return column < row.cells.size() ? row.cells[column].place : row.place;
}

SheetCell cell_at(const SheetRow& row, std::size_t column) {
    return column < row.cells.size() ? row.cells[column] : SheetCell{{}, row.place, false};
}

const std::string& first_text(const SheetRow& row) {
    const auto first = std::ranges::find_if(row.cells, [](const SheetCell& cell) { return !is_blank(cell.text); });
    return text_at(row, static_cast<std::size_t>(first - row.cells.begin()));
}

bool has_number(const SheetRow& row) {
    return std::ranges::any_of(row.cells, [](const SheetCell& cell) {
        return plain_number(cell.text, true).has_value();
    });
}

std::vector<const SheetRow*> value_rows(const Sheet& sheet, std::size_t first, std::size_t end) {
    std::vector<const SheetRow*> rows;
    for (std::size_t k = first; k < std::min(end, sheet.rows.size()); ++k) {
        if (!sheet.rows[k].is_comment) {
            rows.push_back(&sheet.rows[k]);
        }
    }
    return rows;
}

std::size_t width_of(const std::vector<const SheetRow*>& rows) {
    std::size_t most = 0;
    for (const SheetRow* row : rows) {
        most = std::max(most, row->cells.size());
    }
    return most;
}

bool is_blank(std::string_view text) {
    const std::string_view plain = trimmed(text);
    return plain.empty() || plain == "-" || plain == "--" || plain == "\u2013" || plain == "\u2014" || plain == "n/a" ||
           plain == "N/A";
}

std::optional<double> number_at(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    std::string_view text = trimmed(text_at(row, column));
    while (!text.empty() && (text.back() == '%' || std::isalpha(static_cast<unsigned char>(text.back())) != 0)) {
        text = trimmed(text.substr(0, text.size() - 1));
    }
    return plain_number(text, commas_are_decimal(sheet, row, column));
}

} // namespace suffuse::gradings
