#include "suffuse/record/read_import.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/contact_table.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/record/mark_fines.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace suffuse::record {

ImportedSample
read_import(const casefile::ImportSpec& spec, const casefile::Variant& variant, const std::string& where) {
    io::PackingRequest request{.file = spec.path, .density = variant.material.density, .unit = spec.unit};
    request.max_overlap = spec.max_overlap;
    request.radius = spec.radius;
    request.velocity_gradient = spec.velocity_gradient;
    request.where = where;
    if (!(spec.cell == Mat3{})) {
        request.cell = spec.cell;
    }
    io::TakenPacking taken = io::take_packing(request);
    if (!taken.h) {
        throw CaseError(
            spec.place + ": " + taken.no_cell +
            "; give `cell`, three lengths or a 3 x 3 matrix whose columns are the " + "cell vectors"
        );
    }
    mark_fines(variant, spec.path, taken.grains);
    ImportedSample sample{std::move(taken.grains),   *taken.h, taken.velocity_gradient, taken.overlap,
                          std::move(taken.warnings), {}};
    if (!spec.contacts.empty()) {
        sample.contacts = io::read_contacts(spec.contacts, sample.grains);
    }
    return sample;
}

CheckedImports check_imports(const casefile::Case& what) {
    CheckedImports checked;
    std::set<std::string> seen;
    for (const casefile::Study& study : what.studies) {
        for (const casefile::Variant& variant : study.variants) {
            for (const casefile::Stage& stage : variant.stages) {
                const auto* import = std::get_if<casefile::ImportSpec>(&stage.spec);
                if (import == nullptr || !seen.insert(import->place + import->path).second) {
                    continue;
                }
                const ImportedSample sample = read_import(*import, variant, variant.folder + "/" + stage.name);
                checked.largest = std::max(checked.largest, static_cast<std::int64_t>(sample.grains.size()));
                checked.warnings.insert(checked.warnings.end(), sample.warnings.begin(), sample.warnings.end());
            }
        }
    }
    return checked;
}

} // namespace suffuse::record
