#include "suffuse/run/read_import.hpp"

#include "suffuse/run/imported_cell.hpp"
#include "suffuse/run/mark_fines.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <variant>

namespace suffuse::run {
namespace {

constexpr double widest_void_ratio = 20; // of a cloud that is still to be compacted [-]

} // namespace

ImportedSample read_import(const casefile::ImportSpec& spec, double density, const std::string& where) {
    io::ImportedPacking packing = io::read_packing(spec.path, density, spec.unit);
    ImportedSample sample;
    sample.h = imported_cell(spec, packing);
    sample.grains = std::move(packing.grains);
    cell::Cell cell;
    cell.h = sample.h;
    sample.overlap = io::check_overlaps(sample.grains, cell, spec.max_overlap, spec.path);
    sample.warnings = std::move(packing.warnings);
    if (packing.cell && !(packing.cell->h == sample.h)) {
        sample.warnings.push_back(fmt::format("{}: the case's cell is taken, not that of {}", where, spec.path));
    }
    const double solid = grains::solid_volume(sample.grains);
    if (const double e = std::abs(determinant(sample.h)) / solid - 1; e > widest_void_ratio) {
        sample.warnings.push_back(fmt::format(
            "{}: the grains of {} fill a share of {:.1e} of the cell (void ratio {:.3g}): `cell` and `unit` say which "
            "lengths are meant",
            where, spec.path, 1 / (1 + e), e
        ));
    }
    for (const auto& said :
         {io::size_warning(sample.grains, where), io::narrow_cell_warning(sample.grains, sample.h, where)}) {
        if (said) {
            sample.warnings.push_back(*said);
        }
    }
    return sample;
}

std::vector<std::string> check_imports(const casefile::Case& what) {
    std::vector<std::string> warnings;
    std::set<std::string> seen;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec);
                if (import == nullptr || !seen.insert(import->place + import->path).second) {
                    continue;
                }
                const std::string where = variant.folder + "/" + stage.name;
                ImportedSample sample = read_import(*import, variant.material.density, where);
                mark_fines(variant, import->path, sample.grains);
                warnings.insert(warnings.end(), sample.warnings.begin(), sample.warnings.end());
            }
        }
    }
    return warnings;
}

} // namespace suffuse::run
