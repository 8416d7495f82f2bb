#include "suffuse/gradings/sheet_header.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/gradings/derived_values.hpp"
#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/gradings/lexicon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace suffuse::gradings {

namespace {

bool has_kind(const std::vector<Heading>& headings, ColumnKind kind) {
    return std::ranges::any_of(headings, [kind](const Heading& heading) { return heading.kind == kind; });
}

bool has_share(const std::vector<Heading>& headings) {
    return has_kind(headings, ColumnKind::Share) || has_kind(headings, ColumnKind::Gross);
}

/// Headings in two lines: "Sieve" above "(mm)".
std::vector<Heading> join_headings(const SheetRow& above, const SheetRow& below) {
    std::vector<Heading> joined;
    for (std::size_t k = 0; k < above.cells.size(); ++k) {
        joined.push_back(read_heading(text_at(above, k) + " " + text_at(below, k)));
    }
    return joined;
}

/// "Sample,Dmax (mm)", "Dmax (mm),Passing 20 mm,Passing 2 mm": a size of each sample is no column of sizes.
void pass_over_results(const SheetRow& cells, std::vector<Heading>& headings) {
    const auto sizes = columns_of_kind(headings, ColumnKind::Size);
    const auto sieves =
        std::ranges::count_if(cells.cells, [](const SheetCell& cell) { return !size_among_words(cell.text).empty(); });
    if (sizes.size() == 1 && (sieves > 1 || has_kind(headings, ColumnKind::Sample))) {
        const auto result = read_derived_name(cells.cells[sizes.front()].text);
        const bool is_one =
            result && (result->kind == DerivedValue::Kind::Largest || result->kind == DerivedValue::Kind::SizeAt);
        headings[sizes.front()].kind = is_one ? ColumnKind::Other : ColumnKind::Size;
    }
}

/// A row of headings: one says size, and no cell of it is one.
std::optional<SheetHeader> read_header(const SheetRow& cells, std::size_t row) {
    SheetHeader header{row, 1, {}, false};
    for (const SheetCell& cell : cells.cells) {
        header.headings.push_back(read_heading(cell.text));
    }
    pass_over_results(cells, header.headings);
    const bool has_size = has_kind(header.headings, ColumnKind::Size);
    header.is_complete = has_size && has_share(header.headings);
    return has_size && header.headings.size() > 1 ? std::optional(std::move(header)) : std::nullopt;
}

/// Whether a row may be one of headings: none of its cells holds a number.
bool has_no_digit(const SheetRow& row) {
    return std::ranges::none_of(row.cells, [](const SheetCell& cell) {
        return cell.text.find_first_of("0123456789") != std::string::npos;
    });
}

/// Headings in two lines of which the second alone has the size: complete, or none.
std::optional<SheetHeader> join_above(const Sheet& sheet, std::size_t row) {
    const SheetRow &above = sheet.rows[row - 1], &below = sheet.rows[row];
    if (above.is_comment || above.place.line + 1 != below.place.line || above.cells.size() < below.cells.size() ||
        !has_no_digit(above) || !has_no_digit(below)) {
        return std::nullopt;
    }
    SheetHeader joined{row - 1, 2, join_headings(above, below), false};
    bool has_size_below = false, has_share_above = false;
    for (std::size_t k = 0; k < above.cells.size(); ++k) {
        const bool is_size = read_heading(text_at(below, k)).kind == ColumnKind::Size;
        has_size_below = has_size_below || is_size;
        has_share_above = has_share_above || (!is_size && read_heading(text_at(above, k)).kind == ColumnKind::Share);
    }
    joined.is_complete = has_size_below && has_share_above && has_kind(joined.headings, ColumnKind::Size) &&
                         has_kind(joined.headings, ColumnKind::Share);
    return joined.is_complete ? std::optional(std::move(joined)) : std::nullopt;
}

/// The first complete row of headings, else the first with a size.
std::optional<SheetHeader> find_first_line(const Sheet& sheet) {
    std::optional<SheetHeader> best;
    for (const bool in_comments : {false, true}) {
        const std::size_t end = std::min(sheet.rows.size(), most_titles);
        for (std::size_t k = 0; k < end; ++k) {
            if (sheet.rows[k].is_comment != in_comments) {
                continue;
            }
            const bool is_value = !in_comments && sheet.rows[k].cells.size() > 1 && is_size(sheet, sheet.rows[k], 0) &&
                                  number_at(sheet, sheet.rows[k], 1);
            auto header = is_value ? std::nullopt : read_header(sheet.rows[k], k);
            if (header && header->is_complete) {
                return header;
            }
            if (!is_value && !in_comments && k > 0) { // "Particle,% passing" above "Size mm,"
                if (auto joined = join_above(sheet, k)) {
                    return joined;
                }
            }
            if (header && !best && !in_comments) {
                best = std::move(header);
            }
        }
        if (best) {
            return best;
        }
    }
    return best;
}

/// Whether a row goes on with the headings above it: words in most columns, and no number.
bool goes_on(const Sheet& sheet, std::size_t row, std::size_t columns) {
    if (row >= sheet.rows.size() || sheet.rows[row].is_comment || 2 * sheet.rows[row].cells.size() < columns) {
        return false;
    }
    return has_no_digit(sheet.rows[row]) && std::ranges::none_of(sheet.rows[row].cells, [](const SheetCell& cell) {
               return read_row_word(cell.text) != RowWord::None;
           });
}

constexpr std::size_t most_columns = 2000;

bool names_dry_mass(const std::string& words) {
    const bool is_before = mentions(Topic::Before, words); // washing, sieving
    return mentions(Topic::Mass, words) && (is_before || mentions(Topic::WholeSample, words)) &&
           (is_before ? !mentions(Topic::Drying, words) : !mentions(Topic::OtherMass, words));
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

/// The text behind a colon or =, else the next cell that holds something.
std::string value_after(const SheetRow& row, std::size_t column) {
    const std::string& text = row.cells[column].text;
    const std::size_t colon = text.find_first_of(":=");
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
    for (const std::string_view word : split_words(text, " \t()[],:;/=_\"")) {
        const auto role = role_of(trimmed(plain_words(word)));
        const SizeScale scale = size_scale_of(word);
        const bool is_unit = scale == SizeScale::Micrometers || scale == SizeScale::Millimeters;
        unit = is_unit && !is_after_number ? scale : unit;
        names_sizes = names_sizes || role == Role::Size || role == Role::Sieve || is_word_of(Topic::Units, word);
        is_after_number = plain_number(word, true).has_value();
    }
    return names_sizes ? unit : SizeScale::Unknown;
}

} // namespace

std::vector<std::size_t> columns_of_kind(const std::vector<Heading>& headings, ColumnKind kind) {
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < headings.size(); ++k) {
        if (headings[k].kind == kind) {
            columns.push_back(k);
        }
    }
    return columns;
}

bool is_too_wide(const Sheet& sheet, Problems& problems) {
    const auto row =
        std::ranges::find_if(sheet.rows, [](const SheetRow& one) { return one.cells.size() > most_columns; });
    const bool is_wide = row != sheet.rows.end() && row - sheet.rows.begin() < static_cast<std::ptrdiff_t>(most_titles);
    if (is_wide) {
        problems.error(
            "E506", {row->place.source, row->place.line, 1, 1},
            fmt::format("{} columns, and a table of gradings has at most {}", row->cells.size(), most_columns),
            "is this the right file? Write a line for each sieve"
        );
    }
    return is_wide;
}

std::optional<SheetHeader> find_sheet_header(const Sheet& sheet) {
    auto header = find_first_line(sheet);
    if (!header || header->lines > 1 || !goes_on(sheet, header->row + 1, header->headings.size())) {
        return header;
    }
    const SheetRow &first = sheet.rows[header->row], &second = sheet.rows[header->row + 1];
    std::vector<Heading> units = header->headings;
    if (take_unit_row(second, units)) {
        return header; // distinguished by who reads the values
    }
    SheetHeader joined{header->row, 2, join_headings(first, second), false};
    joined.is_complete = has_share(joined.headings);
    return has_kind(joined.headings, ColumnKind::Size) ? joined : header; // else the second line is none of theirs
}

void take_numbered_sieves(Sheet& sheet) {
    const auto header = std::ranges::find_if(sheet.rows, [](const SheetRow& row) {
        return !row.is_comment && row.cells.size() > 1 && !has_number(row);
    });
    if (header == sheet.rows.end()) {
        return;
    }
    const Heading heading = read_heading(header->cells.front().text);
    const bool are_numbers = std::ranges::any_of(sheet.rows, [&](const SheetRow& row) {
        const auto size = row.is_comment ? std::nullopt : size_at(sheet, row, 0, heading.scale);
        return size && (size->notation == SizeNotation::SieveNumber || size->notation == SizeNotation::Inches);
    });
    const bool may_be = heading.scale == SizeScale::SieveNumber || (heading.scale == SizeScale::Unknown && are_numbers);
    std::vector<SheetRow*> sieves;
    for (auto row = header; heading.kind == ColumnKind::Size && may_be && row != sheet.rows.end(); ++row) {
        const std::size_t cells = row->cells.size();
        const auto number = row->is_comment && cells > 1 && cells <= header->cells.size()
                                ? plain_number(row->cells.front().text, false)
                                : std::nullopt;
        bool has_numbers = number && sieve_opening(*number);
        for (std::size_t k = 1; has_numbers && k < cells; ++k) {
            has_numbers = is_blank(row->cells[k].text) || number_at(sheet, *row, k);
        }
        if (has_numbers) {
            sieves.push_back(&*row);
        }
    }
    for (SheetRow* row : sieves) {
        if (sieves.size() > 1) { // one alone may have been taken out of the sheet
            row->is_comment = false, row->cells.front().text.insert(0, "#");
        }
    }
}

bool is_complete_header(const SheetRow& row) {
    const auto header = read_header(row, 0);
    return header && header->is_complete;
}

bool take_unit_row(const SheetRow& row, std::vector<Heading>& headings) {
    std::vector<Heading> units;
    for (std::size_t k = 0; k < headings.size(); ++k) {
        const std::string& text = text_at(row, k);
        const std::string bracketed = text.starts_with('[') || text.starts_with('(') ? text : "(" + text + ")";
        units.push_back(read_heading("x " + bracketed));
        const bool is_unit = units.back().unit != ShareUnit::Unknown || units.back().scale != SizeScale::Unknown;
        if ((!is_unit && !is_blank(text)) || text.find_first_of("0123456789") != std::string::npos) {
            return false;
        }
    }
    for (std::size_t k = 0; k < headings.size(); ++k) {
        headings[k].unit = units[k].unit == ShareUnit::Unknown ? headings[k].unit : units[k].unit;
        headings[k].scale = units[k].scale == SizeScale::Unknown ? headings[k].scale : units[k].scale;
    }
    return true;
}

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
        const std::string_view named = std::string_view(text).substr(0, text.find_first_of(":="));
        if (!names_dry_mass(fmt::format(" {} ", plain_words(named)))) {
            continue;
        }
        const Heading heading = read_heading(named);
        return mass_in(value_after(row, k), heading.mass_unit, commas_are_decimal(sheet, row, k + 1));
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

std::optional<Place> find_unused_mass(const Sheet& sheet, const std::vector<const SheetRow*>& rows) {
    for (const SheetRow* row : rows) {
        for (std::size_t k = 0; k < row->cells.size(); ++k) {
            const std::string_view text = row->cells[k].text;
            const std::string_view named = text.substr(0, text.find_first_of(":="));
            const std::string words = spaced_words(named);
            const bool is_other = mentions(Topic::OtherMass, words) && !mentions(Topic::Before, words);
            const bool comma = commas_are_decimal(sheet, *row, k + 1);
            if (mentions(Topic::Mass, words) && !is_other &&
                mass_in(value_after(*row, k), read_heading(named).mass_unit, comma)) {
                return row->cells[k].place;
            }
        }
    }
    return std::nullopt;
}

bool names_no_diameter(const Heading& heading, std::string_view text) {
    return heading.scale != SizeScale::Phi && mentions(Topic::NoDiameter, spaced_words(text));
}

void complain_about_diameters(const Place& place, std::string_view heading, Problems& problems) {
    problems.error(
        "E506", place, fmt::format("`{}` are no diameters", heading),
        "write diameters, twice the radius, and no logarithms: in a column `d [mm]`"
    );
}

bool names_hydrometer(const SheetRow& row) {
    return std::ranges::any_of(row.cells, [](const SheetCell& cell) {
        const std::string words = fmt::format(" {} ", plain_words(cell.text));
        return mentions(Topic::Hydrometer, words);
    });
}

} // namespace suffuse::gradings
