// The verb remove: fines taken out without water, at once or in passes.

#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/removal.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/run/result_json.hpp"
#include "suffuse/run/stage_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

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

json histogram_of(const std::map<int, std::int64_t>& coordination) {
    json histogram = json::object(); // contacts -> number of removed grains
    for (const auto& [contacts, grains] : coordination) {
        histogram[std::to_string(contacts)] = grains;
    }
    return histogram;
}

/// Of the mean stress, at constant volume: a share.
double stress_loss(const erosion::PassResult& pass) {
    const double before = dem::mean_stress(pass.stress_before);
    return before > 0 ? 1 - dem::mean_stress(pass.stress_constant_volume) / before : 1;
}

json pass_numbers(const erosion::PassResult& pass) {
    return {
        {"pass", pass.pass},
        {"removed", pass.removed},
        {"eroded_mass_percent", pass.eroded_mass_percent},
        {"eroded_mass_percent_of_initial", pass.eroded_mass_percent_of_initial},
        {"coordination_histogram", histogram_of(pass.coordination_histogram)},
        {"stress_before", pass.stress_before},
        {"stress_after_removal", pass.stress_after_removal},
        {"stress_constant_volume", pass.stress_constant_volume},
        {"stress_after", pass.stress_after},
        {"stress_loss", stress_loss(pass)},
        {"porosity_before", pass.porosity_before},
        {"porosity_after_removal", pass.porosity_after_removal},
        {"porosity_after", pass.porosity_after},
        {"void_ratio_after", pass.void_ratio_after},
        {"fines_content_after", pass.fines_content_after},
        {"volumetric_strain", pass.volumetric_strain},
        {"steps", pass.steps},
        {"wall_seconds", pass.wall_seconds},
        {"verdict", pass.verdict}};
}

/// What the passes did together. Stresses before are the first one's, those after the last one's.
json removal_numbers(const dem::World& end, const erosion::RemovalResult& removal) {
    const std::vector<erosion::PassResult>& passes = removal.erosion.passes;
    const erosion::PassResult &first = passes.front(), &last = passes.back();
    const double before = dem::mean_stress(first.stress_before), deviator = axial_difference(first.stress_before);
    std::map<int, std::int64_t> coordination;
    std::int64_t removed = 0, steps = 0;
    double volumetric_strain = 0;
    json of_passes = json::array();
    for (const erosion::PassResult& pass : passes) {
        for (const auto& [contacts, grains] : pass.coordination_histogram) {
            coordination[contacts] += grains;
        }
        removed += pass.removed;
        steps += pass.steps;
        volumetric_strain += pass.volumetric_strain;
        of_passes.push_back(pass_numbers(pass));
    }
    const Vec3 strain = erosion::removal_strain(end, removal);
    return {
        {"removed", removed},
        {"removed_mass_share", erosion::removed_share(end, removal)},
        {"coordination_histogram", histogram_of(coordination)},
        {"stress_before", first.stress_before},
        {"stress_constant_volume", last.stress_constant_volume},
        {"stress_after", dem::mean_stress_tensor(end)},
        {"stress_ratio_before", before > 0 ? deviator / before : 0},
        {"stress_loss", stress_loss(last)},
        {"strain", strain},
        {"largest_strain", std::max({std::abs(strain.x), std::abs(strain.y), std::abs(strain.z)})},
        {"volumetric_strain", volumetric_strain},
        {"porosity_before", first.porosity_before},
        {"porosity_after_removal", last.porosity_after_removal},
        {"failed", last.failed},
        {"passes", of_passes},
        {"steps", steps}};
}

} // namespace

void do_remove(StageWork& work, const erosion::RemoveSpec& spec) {
    const erosion::Surroundings around{
        work.what.fluid, work.what.balance, work.variant.damping, work.what.mode, work.control.pulse()};
    erosion::RemovalResult removal = erosion::begin_removal(work.world, spec);
    bool goes_on = true;
    if (!work.resumed.is_null()) {
        removal = work.resumed.at("removal").get<erosion::RemovalResult>();
    }
    while (goes_on) {
        goes_on = erosion::remove_once(work.world, spec, around, removal);
        work.history.record(work.world, true);
        work.grain_steps += removal.erosion.passes.back().steps * static_cast<std::int64_t>(work.world.grains.size());
        if (goes_on) {
            work.save_partial({{"removal", removal}});
        }
    }
    work.numbers.update(removal_numbers(work.world, removal));
    if (const std::string& verdict = removal.erosion.passes.back().verdict; !verdict.empty()) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), verdict));
    }
    write_removed(work.folder / "eroded.csv", removal.erosion);
}

} // namespace suffuse::run
