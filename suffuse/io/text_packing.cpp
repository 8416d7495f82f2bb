#include "suffuse/io/text_packing.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/headless_packing.hpp"
#include "suffuse/io/packing_columns.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::io {
namespace {

/// Empty where all columns are read.
std::string ignored_warning(const Names& names, const PackingColumns& columns) {
    if (names.back() == unnamed_column) {
        return "the columns behind x y z r are ignored";
    }
    Names ignored;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (columns[k].of == column_kinds) {
            ignored.push_back(names[k]);
        }
    }
    if (ignored.empty()) {
        return "";
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
    const LineReader& reader, const Names& fields, const PackingColumns& columns, const PackingSource& source,
    grains::Grains& grains
) {
    if (fields.size() != columns.size()) {
        reader.complain(fmt::format("found {} fields, expected {}", fields.size(), columns.size()));
    }
    std::array<double, column_kinds> value{};
    value[radius_column] = source.radius.value_or(0);
    bool is_diameter = false;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (const std::size_t of = columns[k].of; of != column_kinds) {
            value[of] = columns[k].factor * to_number(reader, fields[k], column_names[of]);
            is_diameter = is_diameter || columns[k].is_diameter;
        }
    }
    if (!(value[radius_column] > 0)) {
        reader.complain(fmt::format(
            "found {} {}, expected a positive one", is_diameter ? "diameter" : "radius", value[radius_column]
        ));
    }
    const double r = is_diameter ? 0.5 * value[radius_column] : value[radius_column];
    const auto g = grains::add_grain(grains, {value[0], value[1], value[2]}, r, source.density);
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

/// Yade's `format x_y_z_r` counts whatever follows as one column.
Names words_of(std::string_view comment, char mark, std::size_t fields) {
    Names names = split_row(comment, mark);
    if (names.size() == 2 && names.front() == "format") {
        names = split_at(names.back(), '_');
        names.resize(std::max(names.size(), fields), unnamed_column);
    }
    return names;
}

/// The names of so many columns in a comment: as many words, x, y, z and r among them. None where no comment has them.
Names names_in(const Notes& notes, std::size_t fields) {
    for (const std::string_view comment : notes.comments) {
        for (const char mark : {' ', ',', ';', '\t'}) {
            Names names = words_of(comment, mark, fields);
            const PackingColumns columns = columns_of(names);
            const auto needed = {std::size_t{0}, std::size_t{1}, std::size_t{2}, radius_column};
            if (names.size() == fields &&
                std::ranges::all_of(needed, [&](std::size_t of) { return has_column(columns, of); })) {
                return names;
            }
        }
    }
    return {};
}

/// "x [m] y [m]" between blanks: a unit belongs to the word before it.
Names with_units(const Names& words) {
    Names names;
    names.reserve(words.size());
    for (const std::string_view word : words) {
        const bool is_unit = word.starts_with('[') || word.starts_with('(');
        if (is_unit && !names.empty()) {
            const char* const begin = names.back().data();
            names.back() = {begin, static_cast<std::size_t>(word.data() + word.size() - begin)};
        } else {
            names.push_back(word);
        }
    }
    return names;
}

/// What separates columns, found in the first row; a blank for any number of blanks and tabs.
char mark_in(std::string_view line) {
    const std::size_t semicolon = line.find(';'),
                      found = semicolon == std::string_view::npos ? line.find(',') : semicolon;
    return found != std::string_view::npos ? line[found] : has_column(columns_of(split_at(line, '\t')), 0) ? '\t' : ' ';
}

} // namespace

ImportedPacking parse_table(const PackingSource& source) {
    ImportedPacking packing;
    LineReader reader(source.file, source.text);
    const Notes notes = read_notes(source.text, source.file);
    packing.cell = notes.cell;
    if (!reader.next()) {
        return packing;
    }
    const char mark = mark_in(reader.line());
    const Names first = split_row(reader.line(), mark);
    const bool has_header = mark == ' ' ? has_column(columns_of(first), 0) : !is_row_of_numbers(first);
    const auto say = [&](const std::string& remark) {
        if (!remark.empty()) {
            packing.warnings.push_back(fmt::format("{}:{}: {}", source.file, reader.number(), remark));
        }
    };
    Names names = has_header ? with_units(first) : names_in(notes, first.size());
    if (names.empty()) {
        const HeadlessColumns headless = name_columns(reader, source, first, mark);
        names = headless.names;
        say(headless.remark);
    }
    PackingColumns columns = columns_of(names);
    check_columns(reader, names, columns, source.radius.has_value());
    say(apply_units(reader, names, source, columns));
    say(ignored_warning(names, columns));
    if (!has_header) {
        add_row(reader, first, columns, source, packing.grains);
    }
    while (reader.next()) {
        add_row(reader, split_row(reader.line(), mark), columns, source, packing.grains);
    }
    return packing;
}

} // namespace suffuse::io
