#include "suffuse/gradings/sheet_titles.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/gradings/lexicon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::gradings {

namespace {

bool names_dry_mass(const std::string& words) {
    return mentions(Topic::Mass, words) && mentions(Topic::WholeSample, words) &&
           (!mentions(Topic::OtherMass, words) || mentions(Topic::Before, words));
}

std::optional<double> mass_in(std::string_view text, const char* unit, bool comma) {
    std::string number(trimmed(text));
    if (comma) {
        std::replace(number.begin(), number.end(), ',', '.');
    }
    try {
        const bool has_unit = parse_quantity(number).has_unit;
        const double mass = parse_quantity(has_unit ? number : fmt::format("{} {}", number, unit), dimension::mass);
        return mass > 0 ? std::optional(mass) : std::nullopt;
    } catch (const UnitError&) {
        return std::nullopt;
    }
}

/// The text behind a colon, else the next cell that holds something.
std::string value_after(const SheetRow& row, std::size_t column) {
    const std::string& text = row.cells[column].text;
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos && !trimmed(std::string_view(text).substr(colon + 1)).empty()) {
        return std::string(trimmed(std::string_view(text).substr(colon + 1)));
    }
    for (std::size_t k = column + 1; k < row.cells.size(); ++k) {
        if (!is_blank(row.cells[k].text)) {
            return row.cells[k].text;
        }
    }
    return {};
}

/// The unit of sizes that a title gives: one with a number before it is a size itself.
SizeScale size_unit_in(std::string_view text) {
    SizeScale unit = SizeScale::Unknown;
    bool names_sizes = false, is_after_number = false;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t begin = std::min(rest.find_first_not_of(" \t()[],:;/=_\""), rest.size());
        const std::size_t end = std::min(rest.find_first_of(" \t()[],:;/=_\"", begin), rest.size());
        const std::string_view word = rest.substr(begin, end - begin);
        const auto role = role_of(trimmed(plain_words(word)));
        const SizeScale scale = size_scale_of(word);
        const bool is_unit = scale == SizeScale::Micrometers || scale == SizeScale::Millimeters;
        unit = is_unit && !is_after_number ? scale : unit;
        names_sizes = names_sizes || role == Role::Size || role == Role::Sieve || is_word_of(Topic::Units, word);
        is_after_number = plain_number(word, true).has_value();
        rest.remove_prefix(end);
    }
    return names_sizes ? unit : SizeScale::Unknown;
}

} // namespace

StatedUnit find_size_unit(const Sheet& sheet, std::size_t begin, std::size_t end, const StatedUnit& before) {
    StatedUnit found = before;
    for (std::size_t k = begin; k < std::min(end, sheet.rows.size()); ++k) {
        for (const SheetCell& cell : sheet.rows[k].cells) {
            const SizeScale scale = size_unit_in(cell.text);
            found = scale == SizeScale::Unknown ? found : StatedUnit{scale, cell.place};
        }
    }
    return found;
}

std::string sample_named_in(const SheetRow& row) {
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
        const std::string& text = row.cells[k].text;
        const std::string_view named = std::string_view(text).substr(0, std::min(text.find(':'), text.size()));
        const Heading heading = read_heading(named);
        const bool is_mass = names_dry_mass(fmt::format(" {} ", plain_words(named))); // of the sample
        if (heading.kind == ColumnKind::Sample && !heading.names_depth && !is_mass &&
            (k == 0 || heading.rest.empty())) {
            const std::string value = value_after(row, k);
            return value.empty() ? heading.rest : value;
        }
    }
    return {};
}

std::optional<double> dry_mass_in(const Sheet& sheet, const SheetRow& row) {
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
        const std::string& text = row.cells[k].text;
        const std::string_view named = std::string_view(text).substr(0, std::min(text.find(':'), text.size()));
        if (!names_dry_mass(fmt::format(" {} ", plain_words(named)))) {
            continue;
        }
        const Heading heading = read_heading(named);
        const bool is_quoted = k + 1 < row.cells.size() && row.cells[k + 1].is_quoted;
        return mass_in(value_after(row, k), heading.mass_unit, commas_are_decimal(sheet) || is_quoted);
    }
    return std::nullopt;
}

std::optional<double> find_dry_mass(const Sheet& sheet, const std::vector<const SheetRow*>& rows) {
    std::optional<double> found;
    for (const SheetRow* row : rows) {
        const auto mass = dry_mass_in(sheet, *row);
        if (mass && found && std::abs(*mass - *found) > 1e-9 * *found) {
            return std::nullopt;
        }
        found = mass ? mass : found;
    }
    return found;
}

bool names_hydrometer(const SheetRow& row) {
    return std::ranges::any_of(row.cells, [](const SheetCell& cell) {
        const std::string words = fmt::format(" {} ", plain_words(cell.text));
        return mentions(Topic::Hydrometer, words);
    });
}

} // namespace suffuse::gradings
