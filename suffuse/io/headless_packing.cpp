#include "suffuse/io/headless_packing.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/vec3.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::io {
namespace {

constexpr std::size_t mfix_columns = 6;

/// What the first column may be besides x.
struct FirstColumn {
    bool is_whole = true; ///< a number of the grain, or its kind
    bool counts = true;   ///< the rows, from 0 or 1, as many programs do
};

/// Of a table of two rows and more.
FirstColumn look_at_first_column(std::string_view text, char mark) {
    constexpr std::size_t looked_at = 1000, needed_rows = 2, none = std::numeric_limits<std::size_t>::max();
    LineReader reader("", text);
    FirstColumn column;
    std::size_t rows = 0, first = none;
    for (; rows < looked_at && reader.next(); ++rows) {
        const Names f = split_row(reader.line(), mark);
        const std::size_t id = f.empty() ? none : number_of<std::size_t>(f.front()).value_or(none);
        first = rows == 0 ? id : first;
        column.is_whole = column.is_whole && id != none;
        column.counts = column.counts && first <= 1 && id == first + rows;
    }
    return rows >= needed_rows ? column : FirstColumn{false, false};
}

/// Whether the first column is the number of a grain; complains where that is one of two readings.
bool begins_with_ids(const LineReader& reader, const PackingSource& source, std::size_t columns, char mark) {
    const std::size_t needed = source.radius ? 3 : needed_columns;
    const FirstColumn first = look_at_first_column(source.text, mark);
    if (columns == needed + 1 && first.counts) {
        return true;
    }
    if (columns > needed && first.is_whole) {
        reader.complain(
            "the whole numbers in column 1 may be x, or the number or kind of the grain; name the columns in a "
            "line above, such as # id type x y z r"
        );
    }
    if (!source.radius && first.counts) {
        reader.complain(
            "found x y z r, or the number of the grain and x y z, as column 1 counts the rows; write a line "
            "# x y z r above, or of equal grains give their radius, --radius R"
        );
    }
    return false;
}

/// Grains of one reading in the smallest box around them: more than fills it cannot be meant.
class Filling {
public:
    void add(const Vec3& x, double r) {
        for (int k = 0; k < 3; ++k) {
            low_[k] = std::min(low_[k], x[k] - r);
            high_[k] = std::max(high_[k], x[k] + r);
        }
        solid_ += sphere_volume(r);
    }

    [[nodiscard]] bool is_possible() const {
        const Vec3 edges = high_ - low_;
        return solid_ <= edges.x * edges.y * edges.z;
    }

private:
    static constexpr double far = std::numeric_limits<double>::infinity();
    Vec3 low_{far, far, far}, high_{-far, -far, -far};
    double solid_ = 0;
};

enum class SixColumns { Radius, Mfix, Either };

/// Of six columns without names: MFIX's phase is a whole number from 1, its diameter and density are positive.
SixColumns judge_six_columns(std::string_view text, char mark) {
    Filling radius, mfix;
    LineReader reader("", text);
    while (reader.next()) {
        const Names f = split_row(reader.line(), mark);
        Vec3 x;
        std::array<double, mfix_columns> v{};
        for (std::size_t k = 0; k < mfix_columns; ++k) {
            const auto value = f.size() == mfix_columns ? number_of<double>(f[k]) : std::nullopt;
            if (!value || !std::isfinite(*value)) {
                return SixColumns::Radius; // and complains of what it finds
            }
            v[k] = *value;
        }
        if (!(v[3] >= 1) || v[3] != std::floor(v[3]) || !(v[4] > 0) || !(v[5] > 0)) {
            return SixColumns::Radius;
        }
        x = {v[0], v[1], v[2]};
        radius.add(x, v[3]);
        mfix.add(x, v[4] / 2);
    }
    return !mfix.is_possible() ? SixColumns::Radius : radius.is_possible() ? SixColumns::Either : SixColumns::Mfix;
}

/// pandas names columns without names 0, 1, 2, ...
bool may_count_columns(const Names& first) {
    for (std::size_t k = 0; k < first.size(); ++k) {
        if (number_of<std::size_t>(first[k]) != k) {
            return false;
        }
    }
    return true;
}

} // namespace

Names split_row(std::string_view line, char mark) {
    return mark == ' ' ? split_at_blanks(line) : split_at(line, mark);
}

bool is_row_of_numbers(const Names& fields) {
    const std::size_t begin = std::min<std::size_t>(fields.size(), 3);
    const auto is_number = [](std::string_view field) {
        std::string plain(field); // a decimal comma is complained of as a number
        std::ranges::replace(plain, ',', '.');
        return number_of<double>(plain).has_value();
    };
    return begin > 0 && std::all_of(fields.begin(), fields.begin() + static_cast<std::ptrdiff_t>(begin), is_number);
}

HeadlessColumns name_columns(const LineReader& reader, const PackingSource& source, const Names& first, char mark) {
    const bool has_radius = source.radius.has_value();
    if (first.size() < (has_radius ? 3 : needed_columns)) {
        reader.complain(fmt::format(
            "found {} field{}, expected x y z r (or a CSV header x,y,z,r, a LAMMPS, XYZ or VTK file){}", first.size(),
            first.size() == 1 ? "" : "s", first.size() == 3 ? "; for equal grains give their radius: --radius R" : ""
        ));
    }
    if (may_count_columns(first)) {
        reader.complain(
            "found 0, 1, 2, ...: this may be a grain, or a heading that counts the columns; write a heading "
            "x,y,z,r above it or in its place"
        );
    }
    Names names{"x", "y", "z"};
    const SixColumns six =
        first.size() == mfix_columns && !has_radius ? judge_six_columns(source.text, mark) : SixColumns::Radius;
    if (six == SixColumns::Either) {
        reader.complain("column 4 may be the radius, or the phase of MFIX's x y z phase diameter density; name the "
                        "columns in a line above: x y z r a b, or x y z phase diameter density");
    }
    if (six == SixColumns::Mfix) {
        return {
            {"x", "y", "z", "phase", "diameter", "density"},
            "the columns have no headings, and are read as x y z phase diameter density of MFIX"};
    }
    if (begins_with_ids(reader, source, first.size(), mark)) {
        names = {"id", "x", "y", "z"};
    }
    if (!has_radius) {
        names.emplace_back("r");
    }
    names.resize(std::max(names.size(), first.size()), unnamed_column);
    return {names};
}

} // namespace suffuse::io
