#include "suffuse/io/plain_xyz.hpp"

#include "suffuse/io/columns.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::io {
namespace {

using Fields = std::vector<std::string_view>;

/// The line behind the first, which may be empty or begin with #: a LineReader would pass it over.
std::string_view second_line(std::string_view text) {
    const std::size_t end = text.find('\n');
    return end == std::string_view::npos ? std::string_view{}
                                         : trimmed(text.substr(end + 1, text.find('\n', end + 1) - end - 1));
}

bool is_passed_over(std::string_view line) {
    return trimmed(line.substr(0, line.find('#'))).empty();
}

bool are_numbers(const Fields& fields, std::size_t begin) {
    return fields.size() >= begin + 3 && number_of<double>(fields[begin]) && number_of<double>(fields[begin + 1]) &&
           number_of<double>(fields[begin + 2]);
}

/// Goes to the first row of grains, behind the line for people. @return the number of grains
std::optional<std::size_t> go_to_rows(LineReader& reader, std::string_view text) {
    if (!reader.next() || reader.number() != 1) {
        return std::nullopt;
    }
    const auto count = number_of<std::size_t>(reader.line());
    const bool has_words = !is_passed_over(second_line(text));
    return count && (!has_words || reader.next()) && reader.next() ? count : std::nullopt;
}

/// Three lengths and nothing else.
std::optional<cell::Cell> box_in(std::string_view line) {
    const Fields words = split_at_blanks(line);
    Vec3 edges;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto edge = words.size() == 3 ? number_of<double>(words[k]) : std::nullopt;
        if (!edge || !(*edge > 0) || !std::isfinite(*edge)) {
            return std::nullopt;
        }
        edges[static_cast<int>(k)] = *edge;
    }
    return cell::Cell{diagonal(edges), {}};
}

/// Where a row has its position: behind the kind of the grain, unless it has three fields.
std::size_t first_coordinate(const Fields& row) {
    return row.size() == 3 ? 0 : 1;
}

/// Plain XYZ has no radii: a number that may be one is read only where the case says what the others are.
void check_radius(const LineReader& reader, const PackingSource& source, const Fields& row) {
    constexpr std::string_view with_names = "name the columns in line 2: Properties=species:S:1:pos:R:3:radius:R:1";
    const bool begins_with_number = row.size() > 3 && number_of<double>(row[0]);
    if (!source.radius && begins_with_number) {
        reader.complain(fmt::format(
            "found {} numbers: the kind of the grain and x y z, or x y z r; of equal grains give their radius, "
            "--radius R, or {}, or Properties=pos:R:3:radius:R:1",
            row.size(), with_names
        ));
    }
    if (!source.radius && row.size() > 4) {
        reader.complain(fmt::format(
            "found \"{}\" behind the position, which may be the radius; {}, or of equal grains give their radius, "
            "--radius R",
            row[4], with_names
        ));
    }
    if (!source.radius) {
        reader.complain("plain XYZ has no radii; of equal grains give their radius, --radius R");
    }
    if (begins_with_number && !number_of<std::int64_t>(row[0])) {
        reader.complain("found a first number that is no kind of a grain: x y z r, perhaps; the file then contains "
                        "radii, and Properties=pos:R:3:radius:R:1 in line 2 says so");
    }
}

} // namespace

bool looks_like_plain_xyz(std::string_view text) {
    LineReader reader("", text);
    if (!go_to_rows(reader, text)) {
        return false;
    }
    const Fields row = split_at_blanks(reader.line());
    return are_numbers(row, first_coordinate(row));
}

ImportedPacking parse_plain_xyz(const PackingSource& source) {
    ImportedPacking packing;
    LineReader reader(source.file, source.text);
    const std::size_t rows = go_to_rows(reader, source.text).value_or(0);
    packing.cell = box_in(second_line(source.text));
    if (packing.cell) {
        packing.warnings.push_back(fmt::format(
            "{}:2: its box is taken as the periodic cell; an .xyz file does not say which of its sides are walls",
            source.file
        ));
    }
    bool has_row = true, has_more = false;
    for (std::size_t row = 0; row < rows; ++row, has_row = reader.next()) {
        if (!has_row) {
            reader.complain(fmt::format("the file ends after {} grains, expected {}", row, rows));
        }
        const Fields f = split_at_blanks(reader.line());
        const std::size_t at = first_coordinate(f);
        if (f.size() < 3 || f.size() < at + 3) {
            reader.complain(fmt::format("found {} fields, expected the kind of the grain, x, y, z", f.size()));
        }
        check_radius(reader, source, f);
        has_more = has_more || f.size() > at + 3;
        grains::add_grain(packing.grains, vector_in(reader, f, {at, at + 1, at + 2}), *source.radius, source.density);
    }
    if (has_more) {
        packing.warnings.push_back(fmt::format("{}: the columns behind x y z are ignored", source.file));
    }
    if (has_row) {
        packing.warnings.push_back(fmt::format("{}:{}: only the first frame is read", source.file, reader.number()));
    }
    return packing;
}

} // namespace suffuse::io
