#include "suffuse/gradings/sheet_values.hpp"

#include "suffuse/gradings/sieve_size.hpp"

#include <cctype>

namespace suffuse::gradings {

bool commas_are_decimal(const Sheet& sheet) {
    return sheet.mark != ',';
}

bool is_size(const Sheet& sheet, const SheetRow& row, std::size_t column) {
    const SizeText size = split_size_text(text_at(row, column));
    return read_sieve_size(size.text, SizeScale::Unknown, commas_are_decimal(sheet)).has_value();
}

const std::string& text_at(const SheetRow& row, std::size_t column) {
    static const std::string none;
    return column < row.cells.size() ? row.cells[column].text : none;
}

Place place_at(const SheetRow& row, std::size_t column) {
    return column < row.cells.size() ? row.cells[column].place : row.place;
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
    const bool is_quoted = column < row.cells.size() && row.cells[column].is_quoted;
    return plain_number(text, commas_are_decimal(sheet) || is_quoted);
}

} // namespace suffuse::gradings
