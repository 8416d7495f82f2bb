// The verb erode: passes, what they leave to be read.

#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/passage.hpp"
#include "suffuse/facts/ending_words.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/pores/constrictions.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/eroded_table.hpp"
#include "suffuse/run/mobility_record.hpp"
#include "suffuse/run/note_threshold.hpp"
#include "suffuse/run/own_rules.hpp"
#include "suffuse/run/pass_pictures.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/run/take_pass.hpp"
#include "suffuse/run/water_notes.hpp"
#include "suffuse/run/water_numbers.hpp"
#include "suffuse/run/within_pass.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::run {
namespace {

using nlohmann::json;

void note_target(StageWork& work, const erosion::ErodeSpec& spec, const erosion::ErosionResult& result) {
    if (!spec.until_eroded) {
        return;
    }
    const double share = erosion::eroded_share(work.world, result.initial_mass, spec.until_eroded->of);
    if (share < spec.until_eroded->share) {
        work.warnings.push_back(fmt::format(
            "{}: {:.3g} % of the {} left in {} {}, less than the {:.3g} % of `until_eroded`", work.place(), 100 * share,
            name_of(spec.until_eroded->of), result.passes.size(), result.passes.size() == 1 ? "pass" : "passes",
            100 * spec.until_eroded->share
        ));
    }
}

json rule_of(const StageWork& work) {
    return work.own_rule == nullptr ? json() : own_rule_numbers(*work.own_rule);
}

/// Passes of two rules are results of neither.
void require_same_rule(const StageWork& work) {
    if (work.resumed.value("own_rule", json()) != rule_of(work)) {
        throw UsageError(fmt::format(
            "{0}: its first passes were computed with another detachment rule, or one of another text; go on with "
            "that, or remove {1} and resume: the stage then begins anew",
            work.place(), (work.folder / record::partial_file).string()
        ));
    }
}

void note_own_rule(StageWork& work) {
    if (work.own_rule == nullptr) {
        return;
    }
    work.numbers["own_rule"] = rule_of(work);
    work.warnings.push_back(fmt::format(
        "{}: a custom rule, {}, decided which fines are detachable; `detached` of the case was not used", work.place(),
        work.own_rule->name
    ));
    if (work.own_rule->source.empty() && !work.resumed.is_null()) {
        work.warnings.push_back(fmt::format(
            "{}: the text of {} could not be read: it is unknown whether it changed during the stop", work.place(),
            work.own_rule->name
        ));
    }
}

/// Of the relaxation, of probe and twin, or of the fines under their weight.
std::int64_t steps_of_probe(const erosion::PassResult& pass) {
    return pass.mobility ? pass.mobility->rest_steps + pass.mobility->ramp_steps
                         : pass.probe.relax_steps + 2 * (pass.probe.ramp + pass.probe.watch);
}

/// Engineers ask about the soil before erosion; the grains that are left get what the last pass found.
void keep_mobility(StageWork& work, const erosion::ErosionResult& result) {
    std::vector<const erosion::MobilityResult*> ramps;
    for (const erosion::PassResult& pass : result.passes) {
        if (pass.mobility) {
            ramps.push_back(&*pass.mobility);
        }
    }
    if (!ramps.empty()) {
        work.numbers.update(mobility_numbers(*ramps.front()));
        work.mobile_gradient = mobile_gradients(work.world, *ramps.back());
        write_mobility(work.folder, ramps);
    }
}

/// transport.csv: a row a detached grain of a pass, where grains travelled.
void write_transport(const std::filesystem::path& folder, const erosion::ErosionResult& result) {
    const auto travelled = [](const erosion::PassResult& pass) { return pass.transport.distance > 0; };
    if (std::none_of(result.passes.begin(), result.passes.end(), travelled)) {
        return;
    }
    io::CsvWriter table(folder / "transport.csv", "pass,id,d,travel,progress,path,throats,constriction,fate");
    for (const erosion::PassResult& pass : result.passes) {
        const erosion::Transport& t = pass.transport;
        for (std::size_t k = 0; k < t.size(); ++k) {
            table.row(
                pass.pass, t.id[k], t.diameter[k], t.travel[k], t.progress[k], t.path[k], t.throats[k],
                t.constriction[k], name_of(t.fate[k])
            );
        }
    }
    table.finish();
}

/// Of the last pass.
void write_constrictions(const std::filesystem::path& folder, const erosion::ErosionResult& result) {
    if (result.passes.empty()) {
        return;
    }
    const erosion::Constrictions& constrictions = result.passes.back().constrictions;
    io::CsvWriter sizes(folder / "constrictions.csv", "x,y,z,diameter");
    for (std::size_t t = 0; t < constrictions.diameter.size(); ++t) {
        sizes.row(constrictions.center[t], constrictions.diameter[t]);
    }
    sizes.finish();
}

/// What each pass found, and how many steps all took.
void count_passes(StageWork& work, const erosion::ErosionResult& result) {
    json passes = json::array();
    std::int64_t steps = 0; // of the relaxation, of probe and twin, and of the new equilibrium
    std::int64_t grains = std::ssize(work.world.grains.id) + std::ssize(result.ledger); // before the pass
    work.grain_steps = 0;
    for (const erosion::PassResult& pass : result.passes) {
        passes.push_back(pass_numbers(pass));
        const std::int64_t probe_steps = steps_of_probe(pass);
        steps += probe_steps + pass.steps;
        work.grain_steps += probe_steps * grains + pass.steps * (grains - pass.removed);
        grains -= pass.removed;
        work.time_step = pass.probe.time_step;
    }
    work.numbers["passes"] = std::move(passes);
    work.numbers["steps"] = steps;
}

void note_pass(StageWork& work, const erosion::ErodeSpec& spec, const erosion::PassResult& pass) {
    if (pass.mobility) {
        note_mobility(work, fmt::format("pass {}: ", pass.pass), *pass.mobility);
    } else {
        const erosion::DetachSpec rule = erosion::at_pass(spec, pass.pass).detached;
        const bool decides = !spec.forced && work.own_rule == nullptr;
        note_probe(work, rule, pass.probe, decides);
        if (decides) {
            note_threshold(work, fmt::format("pass {}", pass.pass), rule, pass.probe);
        }
    }
    const bool is_usual_end = pass.verdict == erosion::Ending{erosion::NothingLeaves{}} ||
                              (pass.reached_target && !pass.failed && !erosion::doubt_skeleton(work.world));
    if (pass.verdict && !is_usual_end) {
        work.warnings.push_back(fmt::format("{}: pass {}: {}", work.place(), pass.pass, facts::words_of(pass.verdict)));
    }
}

/// Of the first pass, and after the last.
void note_water(StageWork& work, const erosion::ErodeSpec& spec, const erosion::ErosionResult& result) {
    if (result.passes.empty()) {
        return;
    }
    const erosion::PassResult &first = result.passes.front(), &last = result.passes.back();
    const std::string when = fmt::format("after pass {}", last.pass);
    const bool would_resolve = spec.probe.flow.solver == flow::Solver::Auto;
    note_network(work, "before pass 1", first.probe.flow, first.porosity_before, would_resolve);
    note_network(work, when, last.flow_after, last.porosity_after, would_resolve);
    note_closed_voids(work, when + ": ", last.closed_voids);
    note_fast_water(work, when, last.probe.gradient, last.reynolds_after, last.porosity_after);
}

} // namespace

void do_erode(StageWork& work, const erosion::ErodeSpec& spec) {
    erosion::ErosionResult& result = work.findings.erosion.emplace();
    erosion::PassUnderWay now;
    bool goes_on = true;
    if (work.resumed.is_null()) {
        result = erosion::begin_erosion(work.world);
    } else {
        require_same_rule(work);
        result = work.resumed.at("result").get<erosion::ErosionResult>();
        goes_on = work.resumed.at("goes_on");
        now = pass_under_way(work);
    }
    const auto save = [&] {
        json state{{"result", result}, {"goes_on", goes_on}, {"own_rule", rule_of(work)}};
        save_within_pass(work, now, std::move(state));
    };
    work.control.save_with(save);
    const auto passes_done = [&] { return static_cast<int>(result.passes.size()); };
    while (goes_on && (spec.until_nothing_leaves || passes_done() < spec.passes)) {
        // the state between two passes; that after the last is the stage's own
        if (passes_done() > 0 && now.at == erosion::PassUnderWay::At::Start) {
            io::Attributes made_by = work.made_by();
            made_by["stage"] += fmt::format(", pass {}", passes_done());
            io::save_world(record::pass_file(work.folder, passes_done()), work.world, {}, made_by);
        }
        goes_on = take_pass([&] { return erosion::erode_once(work.world, spec, work.surroundings(), result, now); });
        work.history.record(work.world, true);
        save();
    }
    count_passes(work, result);
    for (const erosion::PassResult& pass : result.passes) {
        note_pass(work, spec, pass);
    }
    note_target(work, spec, result);
    note_own_rule(work);
    note_water(work, spec, result);
    keep_mobility(work, result);
    work.numbers["model"] = model_name(spec.probe.gravity && !spec.forced);
    for (const auto of : {erosion::ErodedTarget::Of::Fines, erosion::ErodedTarget::Of::Solids}) {
        work.numbers[fmt::format("eroded_share_of_{}", name_of(of))] =
            erosion::eroded_share(work.world, result.initial_mass, of);
    }
    write_eroded(work.folder, result);
    write_constrictions(work.folder, result);
    write_transport(work.folder, result);
    write_pass_pictures(work, result);
}

} // namespace suffuse::run
