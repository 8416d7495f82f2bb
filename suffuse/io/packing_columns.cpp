#include "suffuse/io/packing_columns.hpp"

#include "suffuse/base/units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace suffuse::io {
namespace {

constexpr std::size_t vectors = 3;                        // position, velocity and spin, in `column_words`
constexpr std::size_t first_velocity = 4, first_spin = 7; // in `column_names`
constexpr Dimension spin_dimension{0, 0, -1, 1};          // rad/s
constexpr std::array vector_begins{std::size_t{0}, first_velocity, first_spin};

/// A heading without its unit.
struct Heading {
    std::string name; ///< as `column_words` writes it
    std::string unit; ///< empty where there is none
};

/// Small letters, an underscore for whatever stands between words.
std::string plain_words_of(std::string_view heading) {
    std::string plain;
    for (const char c : heading) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isalnum(letter) != 0 || letter >= 0x80) {
            plain += static_cast<char>(std::tolower(letter));
        } else if (!plain.empty() && plain.back() != '_') {
            plain += '_';
        }
    }
    return plain.ends_with('_') ? plain.substr(0, plain.size() - 1) : plain;
}

/// "X (mm)" and "x [mm]": what is in the brackets at the end is a unit.
Heading split_heading(std::string_view heading) {
    heading = trimmed(heading);
    if (heading.size() >= 2 && heading.front() == '"' && heading.back() == '"') {
        heading = trimmed(heading.substr(1, heading.size() - 2));
    }
    const bool has_brackets = heading.ends_with(']') || heading.ends_with(')');
    const std::size_t open = has_brackets ? heading.find_last_of("[(") : std::string_view::npos;
    if (open == std::string_view::npos || open == 0) {
        return {plain_words_of(heading), ""};
    }
    return {
        plain_words_of(heading.substr(0, open)),
        std::string(trimmed(heading.substr(open + 1, heading.size() - open - 2)))};
}

std::optional<std::size_t> axis_of(char c) {
    constexpr std::string_view letters = "xyz", digits = "012";
    const std::size_t letter = letters.find(c), digit = digits.find(c);
    return letter < 3 ? std::optional(letter) : digit < 3 ? std::optional(digit) : std::nullopt;
}

bool is_word(std::size_t row, std::string_view word) {
    return std::ranges::find(column_words()[row].words, word) != column_words()[row].words.end();
}

/// The vector that a word names, as its first column.
std::optional<std::size_t> vector_named(std::string_view word) {
    for (std::size_t k = 0; k < vectors; ++k) {
        if (is_word(k, word)) {
            return vector_begins[k];
        }
    }
    return std::nullopt;
}

/// "pos_x", "points_0", "vx", "x_velocity", "x".
std::optional<std::size_t> component_of(std::string_view name) {
    if (name.empty()) {
        return std::nullopt;
    }
    if (const auto axis = axis_of(name.back())) {
        std::string_view word = name.substr(0, name.size() - 1);
        const bool is_apart = word.ends_with('_');
        word.remove_suffix(is_apart ? 1 : 0);
        const bool is_letter = std::isalpha(static_cast<unsigned char>(name.back())) != 0;
        if (word.empty()) {
            return is_letter ? axis : std::nullopt;
        }
        const auto vector = is_apart || is_letter ? vector_named(word) : std::nullopt;
        if (vector) {
            return *vector + *axis;
        }
    }
    if (name.size() > 2 && name[1] == '_' && std::isalpha(static_cast<unsigned char>(name[0])) != 0) {
        const auto axis = axis_of(name[0]);
        const auto vector = vector_named(name.substr(2));
        return axis && vector ? std::optional(*vector + *axis) : std::nullopt;
    }
    return std::nullopt;
}

PackingColumn column_named(std::string_view name) {
    constexpr std::size_t radius_row = 3, diameter_row = 4; // of `column_words`
    if (const auto component = component_of(name)) {
        return {.of = *component};
    }
    const bool is_diameter = is_word(diameter_row, name);
    return is_diameter || is_word(radius_row, name) ? PackingColumn{.of = radius_column, .is_diameter = is_diameter}
                                                    : PackingColumn{};
}

/// "x_mm" is x in mm, where "x_mm" itself is no name.
PackingColumn column_with_unit_behind(const std::string& name) {
    const std::size_t cut = name.find_last_of('_');
    if (cut == std::string::npos) {
        return {};
    }
    PackingColumn column = column_named(name.substr(0, cut));
    const std::string unit = name.substr(cut + 1);
    const bool is_length = column.of < needed_columns;
    constexpr std::array<std::string_view, 5> lengths{"m", "cm", "mm", "um", "nm"};
    if (!is_length || std::ranges::find(lengths, unit) == lengths.end()) {
        return {};
    }
    column.unit = unit;
    return column;
}

PackingColumn column_of(std::string_view text) {
    const Heading heading = split_heading(text);
    PackingColumn column = column_named(heading.name);
    column.unit = heading.unit;
    return column.of == column_kinds && heading.unit.empty() ? column_with_unit_behind(heading.name) : column;
}

Dimension dimension_of(const PackingColumn& column) {
    return column.of < needed_columns ? dimension::length
           : column.of < first_spin   ? dimension::velocity
                                      : spin_dimension;
}

double unit_in_si(const LineReader& reader, std::string_view heading, const PackingColumn& column) {
    const Dimension wanted = dimension_of(column);
    try {
        return parse_unit(column.unit, wanted);
    } catch (const UnitError&) {
        reader.complain(fmt::format(
            "column {}: found the unit \"{}\", expected one of {}, such as {}", trimmed(heading), column.unit,
            wanted == spin_dimension ? "angular velocity" : name_of(wanted),
            wanted == spin_dimension ? "rad/s" : usual_units(wanted).front()
        ));
    }
}

/// Some columns of one kind with a unit, some without: the latter could be in m, or in the unit of the others.
void check_all_have_units(
    const LineReader& reader, const Names& headings, const PackingColumns& columns, const PackingSource& source
) {
    std::string_view with, without;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (columns[k].of < first_spin) {
            (columns[k].unit.empty() ? without : with) = headings[k];
        }
    }
    const bool all_in_m = std::ranges::all_of(columns, [](const PackingColumn& c) {
        return c.of >= first_spin || c.unit.empty() || c.unit == "m" || c.unit == "m/s";
    });
    if (!with.empty() && !without.empty() && source.unit == 1 && !all_in_m) {
        reader.complain(fmt::format(
            "column {} has a unit and column {} has none: it may be in that unit or in m; write the unit of each "
            "column in brackets",
            trimmed(with), trimmed(without)
        ));
    }
}

} // namespace

std::span<const ColumnWords> column_words() {
    static const std::array<ColumnWords, 5> rows{
        {{"position",
          {"position", "positions", "pos", "points", "point", "coordinates", "coordinate", "coords", "coord", "center",
           "centre", "centers", "centres", "centroid", "particle_position"}},
         {"velocity", {"v", "velocity", "velocities", "vel", "velo", "linear_velocity", "particle_velocity"}},
         {"angular velocity", {"w", "omega", "angular_velocity", "ang_vel", "angvel", "spin"}},
         {"radius", {"r", "rad", "radius", "radii", "particle_radius"}},
         {"diameter", {"d", "diam", "diameter", "diameters", "particle_diameter"}}}};
    return rows;
}

bool has_column(const PackingColumns& columns, std::size_t of) {
    return std::ranges::find(columns, of, &PackingColumn::of) != columns.end();
}

PackingColumns columns_of(const Names& headings) {
    PackingColumns columns;
    columns.reserve(headings.size());
    std::ranges::transform(headings, std::back_inserter(columns), column_of);
    const bool has_radius =
        std::ranges::any_of(columns, [](const PackingColumn& c) { return c.of == radius_column && !c.is_diameter; });
    for (PackingColumn& column : columns) {
        column = has_radius && column.is_diameter ? PackingColumn{} : column;
    }
    return columns;
}

void check_columns(
    const LineReader& reader, const Names& headings, const PackingColumns& columns, bool has_radius_for_all
) {
    for (std::size_t k = 0; k < column_kinds; ++k) {
        if (std::ranges::count(columns, k, &PackingColumn::of) > 1) {
            reader.complain(fmt::format("column {} occurs twice", column_names[k]));
        }
        // first column of its vector
        const std::size_t group = k < needed_columns ? 0 : (k - needed_columns) / 3 * 3 + needed_columns;
        const bool wanted = k < needed_columns || has_column(columns, group) || has_column(columns, group + 1) ||
                            has_column(columns, group + 2);
        if (has_radius_for_all && k == radius_column && has_column(columns, k)) {
            reader.complain("the file contains radii, and one for all was given: leave that out");
        }
        if (wanted && !has_column(columns, k) && !(has_radius_for_all && k == radius_column)) {
            reader.complain(fmt::format(
                "column {} is missing; found \"{}\", expected a header with {}", column_names[k],
                fmt::join(headings, ","),
                fmt::join(column_names.begin(), column_names.begin() + (k < needed_columns ? 4 : 10), ",")
            ));
        }
    }
}

std::string
apply_units(const LineReader& reader, const Names& headings, const PackingSource& source, PackingColumns& columns) {
    std::set<std::string> lengths;
    for (std::size_t k = 0; k < columns.size(); ++k) {
        PackingColumn& column = columns[k];
        if (column.of == column_kinds || column.unit.empty()) {
            continue;
        }
        const double own = unit_in_si(reader, headings[k], column);
        if (column.of < first_spin && source.unit != 1 && own != source.unit) {
            reader.complain(fmt::format(
                "column {} is in {} by its heading, and the unit given is {:.6g} m: leave that out, or correct the "
                "heading",
                trimmed(headings[k]), column.unit, source.unit
            ));
        }
        column.factor = column.of < first_spin ? own / source.unit : own;
        if (column.of < needed_columns && own != 1) {
            lengths.insert(column.unit);
        }
    }
    check_all_have_units(reader, headings, columns, source);
    return lengths.empty() ? "" : fmt::format("lengths are in {}, as the headings say", fmt::join(lengths, ", "));
}

} // namespace suffuse::io
