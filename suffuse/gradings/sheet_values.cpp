#include "suffuse/gradings/sheet_values.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sieve_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace suffuse::gradings {

namespace {

/// The number that a text begins with, and its length; with what follows as its unit.
struct Bound {
    double number = 0;
    std::string_view digits, unit;
};

std::optional<Bound> read_bound(std::string_view text) {
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_not_of("0123456789.,"), text.size());
    const auto number = plain_number(text.substr(0, end), true);
    const std::string_view unit = trimmed(text.substr(end));
    if (!number || (!unit.empty() && size_scale_of(unit) == SizeScale::Unknown)) {
        return std::nullopt;
    }
    return Bound{*number, text.substr(0, end), unit};
}

/// Two bounds of one unit: the finer one with it, or what lies below the coarser where the finer is 0.
SizeText finer_of(const Bound& first, const Bound& second) {
    const std::string_view unit = first.unit.empty() ? second.unit : first.unit;
    const Bound &finer = first.number < second.number ? first : second,
                &coarser = first.number < second.number ? second : first;
    const bool is_pan = finer.number == 0;
    const auto with_unit = [&unit](std::string_view digits) {
        return fmt::format("{}{}{}", digits, unit.empty() ? "" : " ", unit);
    };
    return is_pan ? SizeText{with_unit(coarser.digits), SizeSense::Finer, {}}
                  : SizeText{with_unit(finer.digits), SizeSense::Class, with_unit(coarser.digits)};
}

/// 2 mm - 850 um: the units say which is the finer one.
SizeText finer_by_unit(std::string_view first, std::string_view second) {
    const auto a = read_sieve_size(first, SizeScale::Unknown), b = read_sieve_size(second, SizeScale::Unknown);
    const bool rises = a && b && a->diameter < b->diameter;
    return {
        std::string(trimmed(rises ? first : second)), SizeSense::Class, std::string(trimmed(rises ? second : first))};
}

/// "63 - 31.5", "2 to 0.85 mm": the finer bound with its unit.
std::optional<SizeText> split_class(std::string_view text) {
    for (const std::string_view mark : range_marks()) {
        const std::size_t at = text.find(mark);
        if (at == std::string_view::npos || at == 0) {
            continue;
        }
        const std::string_view before = text.substr(0, at), after = text.substr(at + mark.size());
        const auto first = read_bound(before), second = read_bound(after);
        if (!first || !second || first->number == second->number) {
            return std::nullopt;
        }
        const bool have_units = !first->unit.empty() && !second->unit.empty() && first->unit != second->unit;
        return have_units ? finer_by_unit(before, after) : finer_of(*first, *second);
    }
    return std::nullopt;
}

} // namespace

RowWord read_row_word(std::string_view text) {
    const std::string plain = plain_words(text);
    const std::string_view words = trimmed(plain);
    const std::string_view word = words.substr(0, words.find(' '));
    const std::string spaced = fmt::format(" {} ", words);
    const bool is_washed =
        mentions(Topic::Washing, spaced) && is_word_of(Topic::Loss, word); // "Remarks: washed" is a note
    const bool is_note = is_word_of(Topic::PanOrNote, word) && words.find(' ') != std::string_view::npos;
    if ((is_word_of(Topic::Pan, word) && !is_note) || is_washed) {
        return RowWord::Pan;
    }
    const bool is_sum = trimmed(text) == "\u03a3" || trimmed(text) == "\u2211";
    return is_sum || is_word_of(Topic::Total, word) ? RowWord::Total : RowWord::None;
}

SizeText split_size_text(std::string_view text) {
    text = trimmed(text);
    const std::string small = in_small_letters(text);
    for (const SizePrefix& prefix : size_prefixes()) {
        if (small.starts_with(prefix.text)) {
            const std::size_t skipped = prefix.text.ends_with('#') ? prefix.text.size() - 1 : prefix.text.size();
            return {std::string(trimmed(text.substr(skipped))), prefix.sense, {}};
        }
    }
    constexpr double least_number = 20; // "-200" is what passes No. 200; phi does not go as low
    if (text.starts_with('-') && plain_number(text.substr(1), true).value_or(0) > least_number) {
        return {std::string(trimmed(text.substr(1))), SizeSense::Finer, {}};
    }
    if (text.find('/') == std::string_view::npos && !text.empty() && (is_digit(text[0]) || text[0] == '.')) {
        if (auto found = split_class(text)) {
            return *found;
        }
    }
    return {std::string(text), SizeSense::At, {}};
}

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

void append_word(std::string& name, std::string_view part) {
    name += name.empty() || part.empty() ? "" : " ";
    name += part;
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
