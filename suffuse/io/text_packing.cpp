#include "suffuse/io/text_packing.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace suffuse::io {
namespace {

constexpr std::size_t unused = 10; // of the columns below
constexpr std::array<std::string_view, unused> known{"x", "y", "z", "r", "vx", "vy", "vz", "wx", "wy", "wz"};
constexpr std::size_t radius = 3, needed = 4;
constexpr std::string_view unnamed = "...";

/// What a column of a table is.
struct Column {
    std::size_t of = unused; ///< of the known ones
    bool is_diameter = false;
};

using Columns = std::vector<Column>;
using Names = std::vector<std::string_view>;

bool has(const Columns& columns, std::size_t k) {
    return std::ranges::find(columns, k, &Column::of) != columns.end();
}

/// "X [m]" -> "x".
std::string plain_name(std::string_view name) {
    std::string plain;
    for (const char c : name) {
        if (c != '"') {
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    for (const std::string_view unit : {"[m]", "(m)", "[m/s]", "(m/s)", "[rad/s]", "(rad/s)"}) {
        if (plain.ends_with(unit)) {
            plain.resize(plain.size() - unit.size());
            break;
        }
    }
    return plain.substr(0, plain.find_last_not_of(' ') + 1);
}

/// ParaView numbers the components of points and of arrays: Points:0, v:1, or with _.
std::string known_name(const std::string& plain) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 7> vectors{
        {{"points", ""},
         {"coordinates", ""},
         {"v", "v"},
         {"velocity", "v"},
         {"w", "w"},
         {"omega", "w"},
         {"angular_velocity", "w"}}};
    const std::size_t cut = plain.find_last_of(":_");
    if (cut == std::string::npos || cut + 2 != plain.size() || plain[cut + 1] < '0' || plain[cut + 1] > '2') {
        return plain;
    }
    const auto found = std::ranges::find(
        vectors, std::string_view(plain).substr(0, cut), &std::pair<std::string_view, std::string_view>::first
    );
    if (found == vectors.end()) {
        return plain;
    }
    std::string name(found->second);
    name += static_cast<char>('x' + (plain[cut + 1] - '0'));
    return name;
}

Column column_of(std::string_view name) {
    const std::string plain = known_name(plain_name(name));
    const auto k = static_cast<std::size_t>(std::ranges::find(known, plain) - known.begin());
    const bool is_diameter = plain == "d" || plain == "diameter";
    return {is_diameter || plain == "radius" || plain == "radii" ? radius : k, is_diameter};
}

/// Where both are there, the radius is read and not the diameter, whose `d` may mean something else.
Columns columns_of(const Names& names) {
    Columns columns;
    std::ranges::transform(names, std::back_inserter(columns), column_of);
    const bool has_radius =
        std::ranges::any_of(columns, [](const Column& c) { return c.of == radius && !c.is_diameter; });
    for (Column& column : columns) {
        column = has_radius && column.is_diameter ? Column{} : column;
    }
    return columns;
}

void check_columns(const LineReader& reader, const Names& names, const Columns& columns, bool has_radius) {
    for (std::size_t k = 0; k < unused; ++k) {
        if (std::ranges::count(columns, k, &Column::of) > 1) {
            reader.complain(fmt::format("column {} occurs twice", known[k]));
        }
        const std::size_t group = k < needed ? 0 : (k - needed) / 3 * 3 + needed; // first column of its vector
        const bool wanted = k < needed || has(columns, group) || has(columns, group + 1) || has(columns, group + 2);
        if (has_radius && k == radius && has(columns, k)) {
            reader.complain("the file contains radii, and one for all was given: leave that out");
        }
        if (wanted && !has(columns, k) && !(has_radius && k == radius)) {
            const bool has_units = reader.line().find_first_of("[(") != std::string_view::npos;
            reader.complain(fmt::format(
                "column {} is missing; found \"{}\", expected a header with {}{}", known[k], fmt::join(names, ","),
                fmt::join(known.begin(), known.begin() + (k < needed ? 4 : 10), ","),
                has_units ? "; lengths are in m unless `unit` is given" : ""
            ));
        }
    }
}

std::optional<std::string> ignored_warning(const Names& names, const Columns& columns) {
    if (names.back() == unnamed) {
        return "the columns behind x y z r are ignored";
    }
    Names ignored;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (columns[k].of == unused) {
            ignored.push_back(names[k]);
        }
    }
    if (ignored.empty()) {
        return std::nullopt;
    }
    constexpr std::size_t most = 12; // that are named
    const std::size_t left = ignored.size() - std::min(most, ignored.size());
    const char* const plural = ignored.size() == 1 ? "" : "s";
    ignored.resize(ignored.size() - left);
    return fmt::format(
        "column{} \"{}\"{} ignored", plural, fmt::join(ignored, "\", \""),
        left > 0 ? fmt::format(" and {} more", left) : ""
    );
}

void add_row(
    const LineReader& reader, const Names& fields, const Columns& columns, double density, std::optional<double> equal,
    grains::Grains& grains
) {
    if (fields.size() != columns.size()) {
        reader.complain(fmt::format("found {} fields, expected {}", fields.size(), columns.size()));
    }
    std::array<double, unused> value{};
    value[radius] = equal.value_or(0);
    bool is_diameter = false;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (const std::size_t of = columns[k].of; of != unused) {
            value[of] = to_number(reader, fields[k], known[of]);
            is_diameter = is_diameter || columns[k].is_diameter;
        }
    }
    if (!(value[radius] > 0)) {
        reader.complain(
            fmt::format("found {} {}, expected a positive one", is_diameter ? "diameter" : "radius", value[radius])
        );
    }
    const double r = is_diameter ? 0.5 * value[radius] : value[radius];
    const auto g = grains::add_grain(grains, {value[0], value[1], value[2]}, r, density);
    grains.velocity[g] = {value[4], value[5], value[6]};
    grains.spin[g] = {value[7], value[8], value[9]};
}

/// What comments above the first row say.
struct Notes {
    std::vector<std::string_view> comments;
    std::optional<cell::Cell> cell;
};

cell::Cell read_edges(const Names& words, const std::string& file) {
    Vec3 edges;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = words.size() == 4 ? number_of<double>(words[k + 1]) : std::nullopt;
        if (!edge || !(*edge > 0) || !std::isfinite(*edge)) {
            throw CaseError(
                fmt::format("{}: found \"{}\", expected three edges above 0", file, fmt::join(words, " ")), file
            );
        }
        edges[static_cast<int>(k)] = *edge;
    }
    return {diagonal(edges), {}};
}

Notes read_notes(std::string_view text, const std::string& file) {
    constexpr std::string_view blanks = " \t\r\n";
    Notes notes;
    for (std::size_t begin = text.find_first_not_of(blanks); begin < text.size() && text[begin] == '#';) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        notes.comments.push_back(text.substr(begin + 1, end - begin - 1));
        const Names words = split_at_blanks(notes.comments.back());
        if (!words.empty() && words.front() == "#PERIODIC::") {
            notes.cell = read_edges(words, file);
        }
        begin = text.find_first_not_of(blanks, end);
    }
    return notes;
}

/// The names of so many columns in a comment: Yade's `format x_y_z_r`, which counts whatever follows as one, or as many
/// words as there are columns, x, y, z and r among them. None where there is no such comment.
Names names_in(const Notes& notes, std::size_t fields) {
    for (const std::string_view comment : notes.comments) {
        Names names = split_at_blanks(comment);
        if (names.size() == 2 && names.front() == "format") {
            names = split_at(names.back(), '_');
            names.resize(std::max(names.size(), fields), unnamed);
        }
        const Columns columns = columns_of(names);
        if (names.size() == fields && has(columns, 0) && has(columns, 1) && has(columns, 2) && has(columns, radius)) {
            return names;
        }
    }
    return {};
}

/// Whether the first of five columns without names counts the rows from 0 or 1: an id, as many programs write it.
bool begins_with_ids(std::string_view text) {
    constexpr std::size_t looked_at = 1000, needed_rows = 2;
    LineReader reader("", text);
    std::size_t rows = 0, first = 0;
    for (; rows < looked_at && reader.next(); ++rows) {
        const Names f = split_at_blanks(reader.line());
        const auto id = f.empty() ? std::nullopt : number_of<std::size_t>(f.front());
        first = rows == 0 ? id.value_or(2) : first;
        if (f.size() != 5 || !id || first > 1 || *id != first + rows) {
            return false;
        }
    }
    return rows >= needed_rows;
}

/// What separates columns, found in the first row; a blank for any number of blanks and tabs.
char mark_in(std::string_view line) {
    const std::size_t found = line.find_first_of(",;");
    return found != std::string_view::npos ? line[found] : has(columns_of(split_at(line, '\t')), 0) ? '\t' : ' ';
}

} // namespace

ImportedPacking
parse_table(const std::string& file, std::string_view text, double density, std::optional<double> equal) {
    ImportedPacking packing;
    LineReader reader(file, text);
    const Notes notes = read_notes(text, file);
    packing.cell = notes.cell;
    if (!reader.next()) {
        return packing;
    }
    const char mark = mark_in(reader.line());
    const auto split = [&] { return mark == ' ' ? split_at_blanks(reader.line()) : split_at(reader.line(), mark); };
    const Names first = split();
    const bool has_header = mark != ' ' || has(columns_of(first), 0);
    Names names = has_header ? first : names_in(notes, first.size());
    if (names.empty()) {
        if (first.size() < (equal ? 3 : needed)) {
            reader.complain(fmt::format(
                "found {} fields, expected x y z r (or a CSV header x,y,z,r, a LAMMPS, extended XYZ or VTK file){}",
                first.size(), first.size() == 3 ? "; for equal grains give their radius: --radius R" : ""
            ));
        }
        names = {"x", "y", "z"};
        if (begins_with_ids(text)) {
            names = {"id", "x", "y", "z"};
        }
        if (!equal) {
            names.emplace_back("r");
        }
        names.resize(std::max(names.size(), first.size()), unnamed);
    }
    const Columns columns = columns_of(names);
    check_columns(reader, names, columns, equal.has_value());
    if (const auto ignored = ignored_warning(names, columns)) {
        packing.warnings.push_back(fmt::format("{}:{}: {}", file, reader.number(), *ignored));
    }
    if (!has_header) {
        add_row(reader, first, columns, density, equal, packing.grains);
    }
    while (reader.next()) {
        add_row(reader, split(), columns, density, equal, packing.grains);
    }
    return packing;
}

} // namespace suffuse::io
