#include "suffuse/io/packing_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/lammps_dump.hpp"
#include "suffuse/io/lammps_file.hpp"
#include "suffuse/io/text_file.hpp"
#include "suffuse/io/vtp_file.hpp"
#include "suffuse/io/xyz_file.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace suffuse::io {
namespace {

constexpr std::size_t unused = 10; // of the columns below
constexpr std::array<std::string_view, unused> known{"x", "y", "z", "r", "vx", "vy", "vz", "wx", "wy", "wz"};
constexpr std::size_t needed = 4;

/// Which known column each column of a table is.
using Columns = std::vector<std::size_t>;

bool has(const Columns& columns, std::size_t k) {
    return std::ranges::find(columns, k) != columns.end();
}

Columns read_header(const LineReader& reader, std::vector<std::string>& warnings, const std::string& file) {
    Columns columns;
    for (const std::string_view name : split_at_commas(reader.line())) {
        const auto k = static_cast<std::size_t>(std::ranges::find(known, name) - known.begin());
        if (k == unused) {
            warnings.push_back(fmt::format("{}:{}: column \"{}\" ignored", file, reader.number(), name));
        }
        if (k != unused && has(columns, k)) {
            reader.complain(fmt::format("column {} occurs twice", name));
        }
        columns.push_back(k);
    }
    for (std::size_t k = 0; k < known.size(); ++k) {
        const std::size_t group = k < needed ? 0 : (k - needed) / 3 * 3 + needed; // first column of its vector
        const bool wanted = k < needed || has(columns, group) || has(columns, group + 1) || has(columns, group + 2);
        if (wanted && !has(columns, k)) {
            reader.complain(fmt::format(
                "column {} is missing; found \"{}\", expected a header with {}", known[k], reader.line(),
                fmt::join(known.begin(), known.begin() + (k < needed ? 4 : 10), ",")
            ));
        }
    }
    return columns;
}

void add_row(
    const LineReader& reader, const std::vector<std::string_view>& fields, const Columns& columns, double density,
    grains::Grains& grains
) {
    if (fields.size() != columns.size()) {
        reader.complain(fmt::format("found {} fields, expected {}", fields.size(), columns.size()));
    }
    std::array<double, unused> value{};
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (columns[k] != unused) {
            value[columns[k]] = to_number(reader, fields[k], known[columns[k]]);
        }
    }
    if (!(value[3] > 0)) {
        reader.complain(fmt::format("found radius {}, expected a positive one", value[3]));
    }
    const auto g = grains::add_grain(grains, {value[0], value[1], value[2]}, value[3], density);
    grains.velocity[g] = {value[4], value[5], value[6]};
    grains.spin[g] = {value[7], value[8], value[9]};
}

ImportedPacking parse_csv(const std::string& file, std::string_view text, double density) {
    ImportedPacking packing;
    LineReader reader(file, text);
    reader.next();
    const Columns columns = read_header(reader, packing.warnings, file);
    while (reader.next()) {
        add_row(reader, split_at_commas(reader.line()), columns, density, packing.grains);
    }
    return packing;
}

/// Four columns without a header; Yade may write more behind them.
ImportedPacking parse_yade(const std::string& file, std::string_view text, double density) {
    ImportedPacking packing;
    LineReader reader(file, text);
    Columns columns;
    while (reader.next()) {
        const auto fields = split_at_blanks(reader.line());
        if (columns.empty()) {
            if (fields.size() < needed) {
                reader.complain(fmt::format(
                    "found {} fields, expected x y z r (or a CSV header x,y,z,r, a LAMMPS, extended XYZ or VTK file)",
                    fields.size()
                ));
            }
            columns = {0, 1, 2, 3};
            columns.resize(fields.size(), unused);
            if (columns.size() > needed) {
                packing.warnings.push_back(
                    fmt::format("{}:{}: the columns behind x y z r are ignored", file, reader.number())
                );
            }
        }
        add_row(reader, fields, columns, density, packing.grains);
    }
    return packing;
}

bool looks_like_csv(std::string_view text) {
    LineReader reader("", text);
    return reader.next() && reader.line().find(',') != std::string_view::npos;
}

ImportedPacking parse_any(const std::string& file, std::string_view text, double density) {
    if (looks_like_vtp(text)) {
        return parse_vtp(file, text, density);
    }
    if (looks_like_lammps_dump(text)) {
        return parse_lammps_dump(file, text, density);
    }
    if (looks_like_extended_xyz(text)) {
        return parse_extended_xyz(file, text, density);
    }
    if (looks_like_lammps(text)) { // before CSV: its title may hold a comma
        return parse_lammps(file, text, density);
    }
    return looks_like_csv(text) ? parse_csv(file, text, density) : parse_yade(file, text, density);
}

/// Grains that reach beyond their images are a mistake of units; looked for as pairs, each would touch thousands of
/// them.
void check_sizes(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    const double narrowest = std::min({norm(h.column(0)), norm(h.column(1)), norm(h.column(2))});
    const double largest = 2 * *std::max_element(grains.radius.begin(), grains.radius.end());
    if (largest > 2 * narrowest) {
        throw CaseError(
            fmt::format(
                "{}: the largest grain has a diameter of {:.6g} m in a cell {:.6g} m wide; lengths in the file are in "
                "m: check its unit, and that of the cell",
                origin, largest, narrowest
            ),
            origin
        );
    }
}

/// A position that no image of the cell can name is a mistake of the file; later it would pass for a motion blown up.
void check_positions(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    const Mat3 inverse_h = inverse(h);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3& x = grains.position[g];
        if (!std::isfinite(norm2(x)) || !cell::has_period(inverse_h, x)) {
            throw CaseError(
                fmt::format(
                    "{}: grain {}: found the position ({:.6g}, {:.6g}, {:.6g}) m, more than {} cells away from the "
                    "first; check the row and that lengths are in m",
                    origin, grains.id[g], x.x, x.y, x.z, grouped(cell::largest_period)
                ),
                origin
            );
        }
    }
}

void scale(ImportedPacking& packing, double unit) {
    grains::Grains& grains = packing.grains;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        grains.position[g] = unit * grains.position[g];
        grains.velocity[g] = unit * grains.velocity[g];
        grains.radius[g] *= unit;
        grains.mass[g] *= unit * unit * unit;
        grains.inertia[g] *= std::pow(unit, 5);
    }
    if (packing.cell) {
        packing.cell->h = unit * packing.cell->h;
    }
}

} // namespace

ImportedPacking read_packing(const std::filesystem::path& path, double density, double unit) {
    const std::string file = path.string(), text = read_text(path);
    ImportedPacking packing = parse_any(file, text, density);
    if (packing.grains.size() == 0) {
        throw CaseError(fmt::format("{}: no grains found, expected at least one row below the header", file), file);
    }
    if (unit != 1) {
        scale(packing, unit);
    }
    return packing;
}

std::optional<std::string> size_warning(const grains::Grains& grains, const std::string& origin) {
    constexpr double coarsest = 63e-3, finest = 1e-7; // gravel ends, and clay is colloidal, there [m]
    std::vector<double> radius = grains.radius;
    const auto middle = radius.begin() + std::ssize(radius) / 2;
    std::nth_element(radius.begin(), middle, radius.end());
    const double median = 2 * *middle;
    if (median >= finest && median <= coarsest) {
        return std::nullopt;
    }
    return fmt::format(
        "{}: the median diameter is {:.4g} m, {}; lengths are read in m: of a file in mm say so, by unit = \"1 mm\" "
        "in a case and in Python, --unit mm of suffuse import",
        origin, median, median > coarsest ? "coarser than gravel" : "finer than clay"
    );
}

std::optional<std::string> narrow_cell_warning(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    const Vec3 width = cell::widths(h);
    const double ratio =
        std::min({width.x, width.y, width.z}) / (2 * *std::max_element(grains.radius.begin(), grains.radius.end()));
    if (ratio >= grains::narrow_cell) {
        return std::nullopt;
    }
    return fmt::format(
        "{}: the cell is {:.1f} times as wide as the largest grain; below {:.0f} times results depend on the sample",
        origin, ratio, grains::narrow_cell
    );
}

double check_overlaps(const grains::Grains& grains, const cell::Cell& cell, double share, const std::string& origin) {
    check_sizes(grains, cell.h, origin);
    check_positions(grains, cell.h, origin);
    const std::vector<neighbors::Pair> pairs = neighbors::find_pairs(cell.h, grains.position, grains.radius, 0.0);
    double worst = 0;
    const neighbors::Pair* pair = nullptr;
    for (const neighbors::Pair& p : pairs) {
        const double ri = grains.radius[p.first], rj = grains.radius[p.second];
        const Vec3 branch = grains.position[p.second] + cell::shift(cell.h, p.image) - grains.position[p.first];
        const double ratio = (ri + rj - norm(branch)) / std::min(ri, rj);
        if (ratio > worst) {
            worst = ratio;
            pair = &p;
        }
    }
    if (pair != nullptr && worst > share) {
        const auto i = pair->first, j = pair->second;
        throw CaseError(
            fmt::format(
                "{}: {} overlap by {:.3g} of the smaller radius ({:.6g} mm), allowed {:.3g}; check that the cell is "
                "the packing's own and that lengths are in m, or allow a larger overlap",
                origin,
                i == j ? fmt::format("grain {} and its own image", grains.id[i])
                       : fmt::format("grains {} and {}", grains.id[i], grains.id[j]),
                worst, std::min(grains.radius[i], grains.radius[j]) * 1e3, share
            ),
            origin
        );
    }
    return worst;
}

} // namespace suffuse::io
