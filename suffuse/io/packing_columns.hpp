#pragma once
// Columns of a table of grains by their headings: "x", "Position X (mm)", "pos-x", "Points:0", "Diameter [um]". A unit
// in brackets or at the end belongs to its column.

#include "suffuse/io/packing_source.hpp"
#include "suffuse/io/text_file.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

using Names = std::vector<std::string_view>;

/// What columns can hold: the components of position, velocity and spin, and the radius.
constexpr std::size_t column_kinds = 10;
constexpr std::array<std::string_view, column_kinds> column_names{"x",  "y",  "z",  "r",  "vx",
                                                                  "vy", "vz", "wx", "wy", "wz"};
constexpr std::size_t radius_column = 3; ///< or the diameter
constexpr std::size_t needed_columns = 4;

struct PackingColumn {
    std::size_t of = column_kinds; ///< of `column_names`; beyond them where the column is not read
    bool is_diameter = false;
    std::string unit = {}; ///< as written in the heading; empty where there is none
    double factor = 1;     ///< from the column to `unit` of the source, and rad/s
};

using PackingColumns = std::vector<PackingColumn>;

/// Words that a heading may have for a position, a velocity or a spin, with x, y, z or 0, 1, 2 next to them, and for
/// the radius and the diameter. Small letters; blanks, hyphens, points and colons count as underscores.
struct ColumnWords {
    std::string_view meaning;
    std::vector<std::string_view> words;
};

/// In this order: position, velocity, spin, radius, diameter.
std::span<const ColumnWords> column_words();

bool has_column(const PackingColumns& columns, std::size_t of);

/// Where both are there, the radius is read and not the diameter, whose `d` may mean something else.
PackingColumns columns_of(const Names& headings);

/// Complains of columns that are missing or occur twice, and of a radius for all next to own ones.
void check_columns(
    const LineReader& reader, const Names& headings, const PackingColumns& columns, bool has_radius_for_all
);

/// Sets the factors. Complains of what is no unit, of another unit than that of the source, and of lengths and
/// velocities some of which have a unit and others none. @return a remark where headings give units other than m, else
/// an empty text.
std::string
apply_units(const LineReader& reader, const Names& headings, const PackingSource& source, PackingColumns& columns);

} // namespace suffuse::io
