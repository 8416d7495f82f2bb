#include "suffuse/io/vtp_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/legacy_vtk.hpp"
#include "suffuse/io/vtk_reader.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::io {
namespace {

using Arrays = std::map<std::string, VtkColumn>;

/// The first of these point arrays that is there, with a row a point.
const VtkColumn*
find(const Arrays& arrays, std::initializer_list<const char*> names, std::size_t components, std::size_t rows) {
    for (const char* name : names) {
        const auto at = arrays.find(std::string("PointData/") + name);
        if (at != arrays.end() && at->second.components == components &&
            at->second.values.size() == components * rows) {
            return &at->second;
        }
    }
    return nullptr;
}

Vec3 vector_at(const VtkColumn& column, std::size_t row) {
    return {column.values[3 * row], column.values[3 * row + 1], column.values[3 * row + 2]};
}

std::optional<cell::Cell> read_cell(const Arrays& arrays, const std::string& file) {
    const auto at = arrays.find("FieldData/cell");
    if (at == arrays.end() || at->second.values.size() != 9) {
        return std::nullopt;
    }
    const std::vector<double>& v = at->second.values;
    const Mat3 h = from_columns({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]});
    if (!(determinant(h) > 0)) {
        throw CaseError(fmt::format("{}: field array cell: its vectors span no volume", file), file);
    }
    return cell::Cell{h, {}};
}

} // namespace

bool looks_like_vtp(std::string_view text) {
    return text.substr(0, 1000).find("<VTKFile") != std::string_view::npos;
}

ImportedPacking
parse_vtp(const std::string& file, std::string_view text, double density, std::optional<double> equal_radius) {
    const Arrays arrays =
        looks_like_legacy_vtk(text) ? read_legacy_vtk_arrays(file, text) : read_vtk_arrays(file, text);
    const auto points = arrays.find("Points");
    if (points == arrays.end() || points->second.components != 3) {
        throw CaseError(fmt::format("{}: has no points, expected a point a grain", file), file);
    }
    const std::size_t rows = points->second.values.size() / 3;
    const VtkColumn* radius = find(arrays, {"radius", "Radius", "radii", "r", "Radii"}, 1, rows);
    const VtkColumn* diameter = find(arrays, {"diameter", "Diameter"}, 1, rows);
    const bool has_size = radius != nullptr || diameter != nullptr;
    if (!has_size && !equal_radius) {
        throw CaseError(
            fmt::format(
                "{}: has no point array radius or diameter of a value a point; for equal grains give their radius", file
            ),
            file
        );
    }
    if (has_size && equal_radius) {
        throw CaseError(fmt::format("{}: contains radii, and one for all was given: leave that out", file), file);
    }
    const VtkColumn* velocity = find(arrays, {"velocity", "linVelVec", "v", "Velocity"}, 3, rows);
    const VtkColumn* spin = find(arrays, {"angular_velocity", "angVelVec", "omega", "AngularVelocity"}, 3, rows);
    const VtkColumn* fine = find(arrays, {"fine"}, 1, rows);
    ImportedPacking packing;
    packing.cell = read_cell(arrays, file);
    for (std::size_t row = 0; row < rows; ++row) {
        const double r = radius != nullptr     ? radius->values[row]
                         : diameter != nullptr ? 0.5 * diameter->values[row]
                                               : *equal_radius;
        const Vec3 x = vector_at(points->second, row);
        const Vec3 v = velocity != nullptr ? vector_at(*velocity, row) : Vec3{};
        const Vec3 w = spin != nullptr ? vector_at(*spin, row) : Vec3{};
        if (!(r > 0) || !std::isfinite(r) || !std::isfinite(norm(x)) || !std::isfinite(norm(v)) ||
            !std::isfinite(norm(w))) {
            throw CaseError(
                fmt::format(
                    "{}: point {}: expected finite numbers and a positive radius, found radius {}", file, row, r
                ),
                file
            );
        }
        const auto g = grains::add_grain(packing.grains, x, r, density);
        packing.grains.velocity[g] = v;
        packing.grains.spin[g] = w;
        packing.grains.fine[g] = fine != nullptr && fine->values[row] != 0 ? 1 : 0;
    }
    return packing;
}

} // namespace suffuse::io
