#include "suffuse/io/packing_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/lammps_dump.hpp"
#include "suffuse/io/lammps_file.hpp"
#include "suffuse/io/legacy_vtk.hpp"
#include "suffuse/io/mercury_file.hpp"
#include "suffuse/io/text_file.hpp"
#include "suffuse/io/text_packing.hpp"
#include "suffuse/io/vtp_file.hpp"
#include "suffuse/io/xyz_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace suffuse::io {
namespace {

ImportedPacking
parse_any(const std::string& file, std::string_view text, double density, std::optional<double> radius) {
    if (looks_like_vtp(text) || looks_like_legacy_vtk(text)) {
        return parse_vtp(file, text, density, radius);
    }
    if (looks_like_lammps_dump(text)) {
        return parse_lammps_dump(file, text, density, radius);
    }
    if (looks_like_mercury_restart(text)) {
        return parse_mercury_restart(file, text, density);
    }
    if (looks_like_mercury_data(text)) {
        return parse_mercury_data(file, text, density);
    }
    if (looks_like_extended_xyz(text)) {
        return parse_extended_xyz(file, text, density);
    }
    if (looks_like_lammps(text)) { // before tables: its title may hold a comma
        return parse_lammps(file, text, density, radius);
    }
    return parse_table(file, text, density, radius);
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

ImportedPacking
read_packing(const std::filesystem::path& path, double density, double unit, std::optional<double> radius) {
    const std::string file = path.string(), text = read_text(path);
    const auto in_file = radius ? std::optional(*radius / unit) : std::nullopt;
    ImportedPacking packing = parse_any(file, text, density, in_file);
    if (packing.grains.size() == 0) {
        throw CaseError(fmt::format("{}: no grains found, expected at least one", file), file);
    }
    if (unit != 1) {
        scale(packing, unit);
    }
    return packing;
}

} // namespace suffuse::io
