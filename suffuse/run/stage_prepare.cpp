// The verbs that bring a sample into being: import, pack, compact.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/given_contacts.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/erosion/extraction.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/seed.hpp"
#include "suffuse/packing/skeleton_first.hpp"
#include "suffuse/packing/stack.hpp"
#include "suffuse/packing/target_density.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/record/read_import.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/stage_work.hpp"

#include <fmt/format.h>

namespace suffuse::run {
namespace {

constexpr const char* skeleton_key = "skeleton"; // of the numbers of what was made skeleton first

/// Turns a wanted intergranular void ratio into the void ratio of this sample: e = e_g (1 - FC) - FC.
packing::CompactSpec with_void_ratio(packing::CompactSpec spec, const grains::Grains& grains) {
    if (!spec.intergranular_void_ratio) {
        return spec;
    }
    const double content = erosion::fines_content(grains), wanted = *spec.intergranular_void_ratio;
    spec.void_ratio = wanted * (1 - content) - content;
    if (!(*spec.void_ratio > 0)) {
        throw StateError(fmt::format(
            "an intergranular void ratio of {:.4g} leaves no room for the fines: at a fines content of {:.4g} % the "
            "void ratio would be {:.4g}; specify more than {:.4g}",
            wanted, 100 * content, *spec.void_ratio, content / (1 - content)
        ));
    }
    return spec;
}

enum class Part {
    Whole,  ///< what the stage hands on: it can be resumed between bursts
    OfMore, ///< a trial among several, or a skeleton alone: done anew where it was interrupted
};

/// One compaction. A trial ends as soon as it is seen to miss the specified void ratio.
void compact(StageWork& work, const packing::CompactSpec& spec, packing::CompactState state, Part part) {
    if (part == Part::Whole) {
        work.control.save_with([&] {
            nlohmann::json saved = state;
            if (work.numbers.contains(skeleton_key)) {
                saved[skeleton_key] = work.numbers[skeleton_key];
            }
            work.save_partial(saved);
        });
    }
    dem::StepCaches caches;
    bool done = state.phase == packing::CompactState::Phase::Done;
    while (!done && !packing::misses_void_ratio(work.world, spec, state)) {
        done = packing::compact_burst(work.world, caches, spec, work.what.balance, state);
        work.count_steps(dem::burst_steps);
        work.note_state();
        const bool settling = state.phase != packing::CompactState::Phase::Compact;
        work.control.beat(settling ? "settle" : "compact", state.steps, &work.world);
    }
    work.control.save_with(nullptr);
    work.time_step = state.time_step;
    if (spec.void_ratio) {
        work.numbers["steps_of_trials"] = work.numbers.value("steps_of_trials", std::int64_t{0}) + state.steps;
    }
    work.numbers["protocol"] = packing::name_of(spec.protocol);
    work.numbers["start_porosity"] = state.start_porosity;
    work.numbers["steps"] = state.steps;
    work.numbers["void_ratio_compacted"] = state.void_ratio_compacted;
}

/// The servo holds the stress on each axis; a cell that keeps its angles cannot let go of the shear stresses in
/// between.
void warn_of_shear_stress(StageWork& work, double pressure) {
    constexpr double much = 0.1;
    const double q = dem::deviator_stress(dem::mean_stress_tensor(work.world));
    if (q > much * pressure) {
        work.warnings.push_back(fmt::format(
            "{}: the stress on every axis is {:.4g} kPa, but shear stresses between the axes remain that make a "
            "deviator stress of {:.3g} kPa: shear_stresses = \"released\" lets the cell shear until they are gone; "
            "more grains that carry load make them smaller",
            work.place(), pressure / 1e3, q / 1e3
        ));
    }
}

/// Compactions of one cloud until a void ratio is met.
void search(StageWork& work, const packing::CompactSpec& wanted) {
    const dem::World cloud = work.world;
    const auto reach = [&](const packing::CompactSpec& trial) {
        work.world = cloud;
        work.history.begin_anew();
        work.pictures.begin_anew(cloud);
        const packing::CompactState start =
            packing::begin_compaction(work.world, trial, work.variant.damping, work.what.mode);
        compact(work, trial, start, Part::OfMore);
        return dem::void_ratio(work.world);
    };
    const packing::FoundDensity found = packing::search_void_ratio(wanted, work.world.material, reach);
    work.numbers["preparation_friction"] = found.spec.prepare.friction.value_or(work.variant.material.friction);
    work.numbers["preparation_adhesion"] = {
        {"normal", found.spec.prepare.adhesion_normal.value_or(0)},
        {"shear", found.spec.prepare.adhesion_shear.value_or(0)}};
    if (found.spec.start_porosity) {
        work.numbers["preparation_start_porosity"] = *found.spec.start_porosity;
    }
    work.numbers["preparation_trials"] = found.trials;
    work.numbers["void_ratio_asked"] = *wanted.void_ratio;
    if (!found.is_met) {
        work.warnings.push_back(fmt::format(
            "{}: the void ratio {:.4f} was not met within {}; the nearest that was reached is {:.4f}, and was taken",
            work.place(), *wanted.void_ratio, wanted.void_ratio_tolerance, found.void_ratio
        ));
    }
}

/// The grains of the world, by the specified preparation or by a search for it.
void compact_as_specified(StageWork& work, const packing::CompactSpec& specified, Part part) {
    const packing::CompactSpec spec = with_void_ratio(specified, work.world.grains);
    const bool goes_on = !work.resumed.is_null() && part == Part::Whole;
    if (!goes_on) {
        dem::sort_along_curve(work.world);
    }
    if (spec.void_ratio) {
        search(work, spec);
        return;
    }
    const packing::CompactState state =
        goes_on ? work.resumed.get<packing::CompactState>()
                : packing::begin_compaction(work.world, spec, work.variant.damping, work.what.mode);
    compact(work, spec, state, part);
}

/// @return whether the fines fitted into the voids of the skeleton as it is. Fines alone are their cloud again.
bool put_fines(StageWork& work, const grains::Grains& fines, nlohmann::json& placed) {
    if (work.world.grains.size() == 0) {
        work.world.grains = fines;
        return false;
    }
    const packing::Placing placing = packing::put_into_voids(work.world, fines);
    placed["widening"] = placing.widening;
    if (!placing.touch_none) {
        throw StateError(fmt::format(
            "the fines found no room between the coarse grains, although the skeleton was widened {:.2f} times; take "
            "more coarse grains, or leave `skeleton_first` out",
            placing.widening
        ));
    }
    work.history.begin_anew();
    work.pictures.begin_anew(work.world);
    return placing.widening == 1;
}

/// All grains together, from where the fines were put: those that fitted only settle.
void compact_on_skeleton(StageWork& work, const packing::CompactSpec& together, bool fitted) {
    dem::sort_along_curve(work.world);
    const packing::CompactState start =
        fitted ? packing::begin_settling(work.world, work.variant.damping, work.what.mode)
               : packing::begin_compaction(work.world, together, work.variant.damping, work.what.mode);
    compact(work, together, start, Part::Whole);
}

/// The coarse grains alone, as specified; the fines into their voids; then all of them.
void compact_skeleton_first(StageWork& work, const packing::CompactSpec& specified) {
    packing::CompactSpec together = specified;
    together.intergranular_void_ratio = std::nullopt; // the skeleton's
    nlohmann::json& placed = work.numbers[skeleton_key] = nlohmann::json::object();
    if (!work.resumed.is_null()) {
        placed = work.resumed.at(skeleton_key);
        compact(work, together, work.resumed.get<packing::CompactState>(), Part::Whole);
    } else {
        const grains::Grains fines = packing::take_out_fines(work.world);
        if (work.world.grains.size() > 0) {
            compact_as_specified(work, specified, Part::OfMore);
            placed = {{"void_ratio", dem::void_ratio(work.world)}, {"steps", work.numbers.at("steps")}};
        }
        if (fines.size() == 0) {
            return;
        }
        const bool fitted = put_fines(work, fines, placed);
        compact_on_skeleton(work, together, fitted);
    }
    work.numbers["steps"] = work.numbers["steps"].get<std::int64_t>() + placed.value("steps", std::int64_t{0});
}

void take_cloud(StageWork& work, packing::Cloud cloud) {
    work.world.cell = cloud.cell;
    work.world.reference_h = cloud.cell.h;
    work.world.grains = std::move(cloud.grains);
}

/// Soils one after the other along an axis.
void pack_layers(StageWork& work, const packing::PackSpec& spec) {
    expects(spec.width.has_value(), "layers without a width passed the checks of the case");
    const Pulse pulse = work.control.pulse();
    std::vector<packing::LayerSample> drawn;
    nlohmann::json& layers = work.numbers["layers"] = nlohmann::json::array();
    const double density = work.variant.material.density;
    for (const packing::Layer& layer : spec.layers) {
        const grains::Soil& soil = work.what.soils.at(layer.soil);
        drawn.push_back(packing::sample_layer(soil, packing::solid_of(layer, *spec.width), pulse));
        layers.push_back(
            {{"soil", layer.soil},
             {"grains", drawn.back().grains.radius.size()},
             {"mass", density * drawn.back().solid},
             {"thickness", layer.thickness},
             {"grading_largest_difference", drawn.back().grains.largest_difference}}
        );
    }
    take_cloud(work, packing::make_stack(drawn, spec, density, work.variant.seed, pulse));
}

/// Contacts of the geometry, with the memory that a file has of them.
void add_contacts(StageWork& work, const std::string& file, const std::vector<dem::GivenContact>& given) {
    const dem::TakenContacts taken = dem::add_given_contacts(work.world, given);
    work.numbers["imported_contacts"] = taken.remembered;
    if (taken.unknown + taken.apart > 0) {
        work.warnings.push_back(fmt::format(
            "{}: {} knows {} of the {} contacts; {} do not touch here. Those without memory have no shear force",
            work.place(), file, taken.remembered, taken.remembered + taken.unknown,
            plural(static_cast<std::int64_t>(taken.apart), "other pair")
        ));
    }
    if (const std::optional<std::string> words = dem::words_on_cut(taken, file)) {
        work.warnings.push_back(work.place() + ": " + *words);
    }
}

} // namespace

void do_import(StageWork& work, const casefile::ImportSpec& spec) {
    record::ImportedSample sample = record::read_import(spec, work.variant, work.place());
    work.world.cell.h = sample.h;
    work.world.cell.velocity_gradient = sample.velocity_gradient;
    work.world.grains = std::move(sample.grains);
    work.world.reference_h = work.world.cell.h;
    work.numbers["imported"] = true;
    work.numbers["imported_overlap_ratio"] = sample.overlap;
    work.warnings = std::move(sample.warnings);
    if (!spec.contacts.empty()) {
        add_contacts(work, spec.contacts, sample.contacts);
        return;
    }
    dem::add_first_contacts(work.world);
    work.warnings.push_back(fmt::format(
        "{}: this packing carries no contact memory: its contacts are those of the geometry, with normal forces "
        "and without shear forces and moments; settle it where that matters, or name their file in `contacts`",
        work.place()
    ));
}

void do_pack(StageWork& work, const packing::PackSpec& spec) {
    if (!spec.layers.empty()) {
        pack_layers(work, spec);
        return;
    }
    expects(work.variant.soil.has_value(), "a pack stage without a soil passed the checks of the case");
    const Pulse pulse = work.control.pulse();
    const grains::SampledGrains sample =
        grains::sample_soil(*work.variant.soil, static_cast<int>(work.variant.particles), pulse);
    take_cloud(work, packing::make_cloud(sample, spec, work.variant.material.density, work.variant.seed, pulse));
    work.numbers["grading_largest_difference"] = sample.largest_difference;
    work.numbers["grading_tolerance"] = work.variant.soil->grading_tolerance;
    work.numbers["fines_content_reached"] = sample.fines_content;
    if (work.variant.soil->report_kenney_lau) { // next to the split in use
        const std::optional<double> split = grains::kenney_lau_split(grains::specified_grading(*work.variant.soil));
        work.numbers["kenney_lau_split"] = or_null(split);
    }
}

void do_compact(StageWork& work, const packing::CompactSpec& specified) {
    if (specified.prepare.skeleton_first) {
        compact_skeleton_first(work, specified);
    } else {
        compact_as_specified(work, specified, Part::Whole);
    }
    warn_of_shear_stress(work, specified.pressure);
}

} // namespace suffuse::run
