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

Column column_of(std::string_view name) {
    const std::string plain = plain_name(name);
    const auto k = static_cast<std::size_t>(std::ranges::find(known, plain) - known.begin());
    const bool is_diameter = plain == "d" || plain == "diameter";
    return {is_diameter || plain == "radius" ? radius : k, is_diameter};
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

void check_columns(const LineReader& reader, const Names& names, const Columns& columns) {
    for (std::size_t k = 0; k < unused; ++k) {
        if (std::ranges::count(columns, k, &Column::of) > 1) {
            reader.complain(fmt::format("column {} occurs twice", known[k]));
        }
        const std::size_t group = k < needed ? 0 : (k - needed) / 3 * 3 + needed; // first column of its vector
        const bool wanted = k < needed || has(columns, group) || has(columns, group + 1) || has(columns, group + 2);
        if (wanted && !has(columns, k)) {
            const bool has_units = reader.line().find_first_of("[(") != std::string_view::npos;
            reader.complain(fmt::format(
                "column {} is missing; found \"{}\", expected a header with {}{}", known[k], fmt::join(names, ","),
                fmt::join(known.begin(), known.begin() + (k < needed ? 4 : 10), ","),
                has_units ? "; lengths are in m, and `unit` says another one" : ""
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
    return ignored.empty() ? std::nullopt
                           : std::optional(fmt::format(
                                 "column{} \"{}\" ignored", ignored.size() == 1 ? "" : "s", fmt::join(ignored, "\", \"")
                             ));
}

void add_row(
    const LineReader& reader, const Names& fields, const Columns& columns, double density, grains::Grains& grains
) {
    if (fields.size() != columns.size()) {
        reader.complain(fmt::format("found {} fields, expected {}", fields.size(), columns.size()));
    }
    std::array<double, unused> value{};
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

/// What separates columns, told by the first row; a blank for any number of blanks and tabs.
char mark_in(std::string_view line) {
    const std::size_t found = line.find_first_of(",;");
    return found != std::string_view::npos ? line[found] : has(columns_of(split_at(line, '\t')), 0) ? '\t' : ' ';
}

} // namespace

ImportedPacking parse_table(const std::string& file, std::string_view text, double density) {
    ImportedPacking packing;
    LineReader reader(file, text);
    if (text.starts_with("# vtk DataFile")) {
        throw CaseError(
            file + ": is a legacy VTK file, expected .vtp: ParaView saves it as PolyData (Save Data)", file
        );
    }
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
        if (first.size() < needed) {
            reader.complain(fmt::format(
                "found {} fields, expected x y z r (or a CSV header x,y,z,r, a LAMMPS, extended XYZ or VTK file)",
                first.size()
            ));
        }
        names = {"x", "y", "z", "r"};
        names.resize(first.size(), unnamed);
    }
    const Columns columns = columns_of(names);
    check_columns(reader, names, columns);
    if (const auto ignored = ignored_warning(names, columns)) {
        packing.warnings.push_back(fmt::format("{}:{}: {}", file, reader.number(), *ignored));
    }
    if (!has_header) {
        add_row(reader, first, columns, density, packing.grains);
    }
    while (reader.next()) {
        add_row(reader, split(), columns, density, packing.grains);
    }
    return packing;
}

} // namespace suffuse::io
