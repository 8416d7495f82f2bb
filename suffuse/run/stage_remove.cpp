// The verb remove: fines taken out at once, without water.

#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/removal.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/stage_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::run {
namespace {

using nlohmann::json;

void write_removed(const std::filesystem::path& file, const erosion::ErosionResult& result) {
    io::CsvWriter removed(file, "pass,id,d,mass,coordination,reason");
    for (const erosion::LedgerRow& row : result.ledger) {
        removed.row(row.pass, row.grain, row.diameter, row.mass, row.coordination, row.reason);
    }
    removed.finish();
}

/// What a triaxial test calls the deviator: between the axes of the cell. Shear stresses along them, which small
/// samples have at any state, do not count [Pa].
double axial_difference(const Mat3& stress) {
    const auto [least, most] = std::minmax({stress(0, 0), stress(1, 1), stress(2, 2)});
    return most - least;
}

} // namespace

void do_remove(StageWork& work, const erosion::RemoveSpec& spec) {
    const erosion::Surroundings around{
        work.what.fluid, work.what.balance, work.what.damping, work.what.mode, work.control.pulse()};
    const erosion::RemovalResult removal = erosion::remove_fines(work.world, spec, around);
    const erosion::PassResult& pass = removal.erosion.passes.front();
    const double before = dem::mean_stress(pass.stress_before), deviator = axial_difference(pass.stress_before);
    const double kept = before > 0 ? dem::mean_stress(pass.stress_constant_volume) / before : 0;
    const Vec3& strain = removal.strain;
    json histogram = json::object(); // contacts -> number of removed grains
    for (const auto& [contacts, grains] : pass.coordination_histogram) {
        histogram[std::to_string(contacts)] = grains;
    }
    work.history.record(work.world, true);
    work.numbers.update(
        {{"removed", pass.removed},
         {"removed_mass_share", removal.removed_share},
         {"coordination_histogram", histogram},
         {"stress_before", pass.stress_before},
         {"stress_constant_volume", pass.stress_constant_volume},
         {"stress_after", dem::mean_stress_tensor(work.world)},
         {"stress_ratio_before", before > 0 ? deviator / before : 0},
         {"stress_loss", 1 - kept},
         {"strain", strain},
         {"largest_strain", std::max({std::abs(strain.x), std::abs(strain.y), std::abs(strain.z)})},
         {"volumetric_strain", pass.volumetric_strain},
         {"porosity_before", pass.porosity_before},
         {"porosity_after_removal", pass.porosity_after_removal},
         {"failed", !pass.verdict.empty()},
         {"steps", pass.steps}}
    );
    if (!pass.verdict.empty()) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), pass.verdict));
    }
    work.grain_steps = pass.steps * static_cast<std::int64_t>(work.world.grains.size());
    write_removed(work.folder / "eroded.csv", removal.erosion);
}

} // namespace suffuse::run
