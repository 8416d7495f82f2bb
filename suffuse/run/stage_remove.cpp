// The verb remove: fines taken out without water, at once or in passes.

#include "suffuse/cell/strain.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/removal.hpp"
#include "suffuse/facts/ending_words.hpp"
#include "suffuse/facts/pass.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/eroded_table.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/run/take_pass.hpp"
#include "suffuse/run/within_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// What a triaxial test calls the deviator: between the axes of the cell. Shear stresses along them, which small
/// samples have at any state, do not count [Pa].
double axial_difference(const Mat3& stress) {
    const auto [least, most] = std::minmax({stress(0, 0), stress(1, 1), stress(2, 2)});
    return most - least;
}

/// A sample that carried none before, as after a collapse in an earlier pass, has lost all.
double lost_share(const erosion::PassResult& pass) {
    return erosion::stress_loss(pass).value_or(1);
}

json removal_pass(const erosion::PassResult& pass) {
    json numbers = record::facts_json(facts::pass, pass);
    numbers["stress_loss"] = lost_share(pass);
    return numbers;
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
        of_passes.push_back(removal_pass(pass));
    }
    const Vec3 strain = erosion::removal_strain(end, removal);
    return {
        {"removed", removed},
        {"removed_mass_share", erosion::removed_share(end, removal)},
        {"coordination_histogram", facts::histogram_by_name(coordination)},
        {"stress_before", first.stress_before},
        {"stress_constant_volume", last.stress_constant_volume},
        {"stress_after", dem::mean_stress_tensor(end)},
        {"stress_ratio_before", before > 0 ? deviator / before : 0},
        {"stress_loss", lost_share(last)},
        {"strain", strain},
        {"largest_strain", cell::largest_strain(strain)},
        {"volumetric_strain", volumetric_strain},
        {"porosity_before", first.porosity_before},
        {"porosity_after_removal", last.porosity_after_removal},
        {"failed", last.failed},
        {"passes", of_passes},
        {"steps", steps}};
}

} // namespace

void do_remove(StageWork& work, const erosion::RemoveSpec& spec) {
    const erosion::Surroundings around = work.surroundings();
    erosion::RemovalResult removal;
    erosion::PassUnderWay now;
    bool goes_on = true;
    if (work.resumed.is_null()) {
        removal = erosion::begin_removal(work.world, spec);
    } else {
        removal = work.resumed.at("removal").get<erosion::RemovalResult>();
        now = pass_under_way(work);
    }
    const auto save = [&] { save_within_pass(work, now, {{"removal", removal}}); };
    work.control.save_with(save);
    while (goes_on) {
        goes_on = take_pass([&] { return erosion::remove_once(work.world, spec, around, removal, now); });
        work.history.record(work.world, true);
        work.count_steps(removal.erosion.passes.back().steps);
        if (goes_on) {
            save();
        }
    }
    work.time_step = removal.erosion.passes.back().time_step;
    work.numbers.update(removal_numbers(work.world, removal));
    if (const erosion::Ending& ending = removal.erosion.passes.back().verdict) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), facts::words_of(ending)));
    }
    write_eroded(work.folder, removal.erosion);
}

} // namespace suffuse::run
