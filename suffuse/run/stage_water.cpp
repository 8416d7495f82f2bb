// The verbs with water: flow, detach, erode.

#include "suffuse/base/words.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/detachment.hpp"
#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/passage.hpp"
#include "suffuse/erosion/weighed_probe.hpp"
#include "suffuse/flow/pore_velocity.hpp"
#include "suffuse/flow/reynolds.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/flow/throat_flux.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/io/flow_tables.hpp"
#include "suffuse/io/tables.hpp"
#include "suffuse/pores/constrictions.hpp"
#include "suffuse/record/case_hash.hpp"
#include "suffuse/record/ending_words.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/run/mobility_record.hpp"
#include "suffuse/run/note_threshold.hpp"
#include "suffuse/run/pass_record.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/run/take_pass.hpp"
#include "suffuse/run/water_numbers.hpp"
#include "suffuse/stokes/water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// Below this Yade's law is too permeable by 40 % and more: validation/permeability.md.
constexpr double open_packing = 0.55;

/// @param when "of the sample", "after pass 2"
void note_network(
    StageWork& work, const std::string& when, const flow::FlowSource& source, double porosity, bool would_resolve
) {
    if (would_resolve && source.solver == flow::Solver::Network && source.doubt != flow::Doubt::None) {
        work.warnings.push_back(fmt::format(
            "{}: solver \"auto\" would resolve the flow {} ({}), and the cell is sheared: the network's is taken",
            work.place(), when, name_of(source.doubt)
        ));
    }
    if (const std::string words = flow::words_of(source, when); !words.empty()) {
        work.warnings.push_back(fmt::format("{}: {}", work.place(), words));
    }
    const double solid_fraction = 1 - porosity;
    const bool is_yades =
        source.solver == flow::Solver::Network && work.what.fluid.conductance == flow::Conductance::Yade;
    if (is_yades && solid_fraction < open_packing) {
        work.warnings.push_back(fmt::format(
            "{}: the solid fraction {} is {:.3f}: below {} the permeability of conductance = \"yade\" is too high by "
            "40 % and more (validation/permeability.md), and its ratio to a denser state's is too high as well; the "
            "fluid's forces add up to the gradient all the same",
            work.place(), when, solid_fraction, open_packing
        ));
    }
}

/// @param closed with grains by id
void note_closed_voids(StageWork& work, const std::string& when, const flow::ClosedVoids& closed) {
    const std::string words = flow::words_of(closed, [](std::uint32_t id) { return std::to_string(id); });
    if (!words.empty()) {
        work.warnings.push_back(fmt::format("{}: {}{}", work.place(), when, words));
    }
}

/// Where less than this is left of the flow by the water's inertia, which the pore network leaves out.
constexpr double slow_enough = 0.9;

void note_fast_water(StageWork& work, const std::string& when, double gradient, double reynolds, double porosity) {
    const double left = flow::share_left_by_inertia(reynolds, porosity);
    if (left < slow_enough) {
        work.warnings.push_back(fmt::format(
            "{}: at i = {:.3g} the water {} has a Reynolds number of {}: its inertia, which slow flow leaves out, "
            "would leave some {:.0f} % of the flux (Ergun); the permeability told is that of slow flow; the fluid's "
            "forces add up to the gradient all the same",
            work.place(), gradient, when, short_number(reynolds, 2), 100 * left
        ));
    }
}

/// @param decides whether the probe says what leaves
void note_probe(StageWork& work, const erosion::DetachSpec& rule, const erosion::ProbeResult& probe, bool decides) {
    if (probe.reached_floor) {
        work.warnings.push_back(fmt::format(
            "{}: the equilibrium could be relaxed to an unbalanced force of {:.1e} only: double precision, or grains "
            "that creep",
            work.place(), probe.unbalanced_force
        ));
    }
    if (decides && noise_decides(rule, probe)) {
        work.flaws.push_back(fmt::format(
            "{}: {} of {} fines move with the water, but not enough faster than their own twins without: "
            "what detaches cannot be told; take another seed, more `relax_limit`, or `by = \"displacement\"`",
            work.place(), probe.hidden_by_noise, probe.id.size()
        ));
    }
    if (probe.beyond_viscous_time && !probe.id.empty()) { // without fines there is no such time
        work.warnings.push_back(fmt::format(
            "{}: ramp and watch last {:.3g} s, longer than the viscous time {:.3g} s of the fines: the constant force "
            "overstates how far they move",
            work.place(), static_cast<double>(probe.ramp + probe.watch) * probe.time_step, probe.viscous_time
        ));
    }
}

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

/// Of the relaxation, of probe and twin, or of the fines under their weight.
std::int64_t steps_of_probe(const erosion::PassResult& pass) {
    return pass.mobility ? pass.mobility->rest_steps + pass.mobility->ramp_steps
                         : pass.probe.relax_steps + 2 * (pass.probe.ramp + pass.probe.watch);
}

/// The soil of before is what an engineer asks about; grains that are left are told what the last pass found.
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

/// Root of the mean square difference of the network's forces to the resolved ones, over that of these; null at rest.
json force_difference(const std::vector<Vec3>& network, const std::vector<Vec3>& resolved) {
    double difference = 0, size = 0;
    for (std::size_t g = 0; g < resolved.size(); ++g) {
        difference += norm2(network[g] - resolved[g]);
        size += norm2(resolved[g]);
    }
    return or_null(std::sqrt(difference / size));
}

/// The flow between the grains themselves, beside that of the network.
json resolved_numbers(const stokes::ResolvedFlow& flow, const std::vector<Vec3>& network_force) {
    json numbers = {
        {"permeability", flow.permeability},
        {"finer_permeability", flow.finer_permeability},
        {"mean_velocity", flow.mean_velocity},
        {"force_sum", flow.force_sum},
        {"force_difference", force_difference(network_force, flow.grain_force)},
        {"boxes", flow.boxes},
        {"spacing", flow.spacing},
        {"across_smallest", flow.across_smallest},
        {"iterations", flow.iterations},
        {"residual", flow.residual},
        {"seconds", flow.seconds}};
    if (flow.tensor) {
        numbers["permeability_along"] = flow.permeability;
        numbers["permeability"] = *flow.tensor;
    }
    return numbers;
}

} // namespace

void do_flow(StageWork& work, const flow::FlowSpec& spec) {
    const dem::World& world = work.world;
    const grains::Grains& grains = world.grains;
    const stokes::Water water = stokes::solve_water(
        world.cell, grains.position, grains.radius, grains.fine, spec, work.what.fluid, spec.how, work.control.pulse()
    );
    const flow::Seepage& seepage = water.network;
    const flow::FlowSource& source = water.source;
    const bool is_resolved = water.is_resolved();
    const double porosity = dem::porosity(world);
    note_network(work, "of the sample", source, porosity, spec.how.solver == flow::Solver::Auto);
    note_closed_voids(work, "", flow::named_by_id(seepage.closed_voids, grains.id));
    json& numbers = work.numbers;
    numbers.update(source_numbers(source));
    numbers["gradient"] = spec.gradient;
    const double permeability = water.permeability();
    const std::optional<Mat3>& tensor = is_resolved ? water.resolved->tensor : seepage.tensor;
    numbers["permeability"] = permeability;
    if (tensor) {
        numbers["permeability_along"] = permeability;
        numbers["permeability"] = *tensor;
    }
    if (water.resolved) {
        numbers["resolved"] = resolved_numbers(*water.resolved, seepage.grain_force);
        numbers["network_permeability"] = seepage.permeability;
    }
    numbers["mean_velocity"] = is_resolved ? water.resolved->mean_velocity : seepage.mean_velocity;
    const std::vector<Vec3> velocity =
        flow::pore_velocities(seepage.network, grains.position, grains.radius, seepage.field.flux);
    numbers["tortuosity"] = flow::tortuosity(seepage.network, velocity);
    const double reynolds =
        flow::reynolds_number(permeability, spec.gradient, flow::sauter_diameter(grains.radius), work.what.fluid);
    numbers["reynolds_number"] = reynolds;
    note_fast_water(work, "in the sample", spec.gradient, reynolds, porosity);
    numbers["pressure_gradient"] = seepage.pressure_gradient;
    numbers["force_sum"] = is_resolved ? water.resolved->force_sum : seepage.force_sum;
    numbers["force_sum_error"] = seepage.force_sum_error;
    work.findings.throat_flux =
        flow::describe_fluxes(seepage.network, seepage.field.flux, spec.gradient != 0 ? spec.gradient : 1);
    numbers["half_carried_by"] = work.findings.throat_flux->half_carried_by;
    numbers["residual"] = seepage.field.residual;
    numbers["pores"] = seepage.network.pores.size();
    numbers["throats"] = seepage.network.throats.size();
    numbers["hidden_grains"] = seepage.network.hidden.size();
    numbers["seconds"] = {
        {"triangulate", seepage.seconds.triangulate},
        {"conductance", seepage.seconds.conductance},
        {"solve", seepage.seconds.solve},
        {"forces", seepage.seconds.forces}};
    numbers["steps"] = 0;
    if (work.write_tables) {
        io::write_grain_forces_csv(work.folder / "grain_forces.csv", grains, {water.grain_force()});
        if (water.resolved) {
            io::write_grain_forces_csv(work.folder / "resolved_forces.csv", grains, {water.resolved->grain_force});
        }
        io::write_pores_csv(work.folder / "pores.csv", seepage.network, seepage.field.pressure, velocity);
        io::write_throats_csv(work.folder / "throats.csv", seepage.network, seepage.conductance, seepage.field.flux);
    }
    if (record::writes(work.what.output, "vtp")) {
        io::write_pores_vtu(
            work.folder / "pores.vtu", seepage.network, grains.position, seepage.field.pressure, velocity
        );
    }
}

namespace {

void detach_with_weight(StageWork& work, const erosion::DetachStageSpec& spec) {
    const erosion::MobilityResult& mobility =
        work.findings.mobility.emplace(erosion::probe_mobility(work.world, spec, work.surroundings()));
    work.numbers.update(mobility_numbers(mobility));
    work.numbers.update(source_numbers(mobility.flow));
    note_network(
        work, "of the sample", mobility.flow, dem::porosity(work.world), spec.probe.flow.solver == flow::Solver::Auto
    );
    note_mobility(work, "", mobility);
    work.time_step = mobility.time_step;
    work.numbers["steps"] = mobility.rest_steps + mobility.ramp_steps;
    work.count_steps(work.numbers["steps"]);
    work.mobile_gradient = mobile_gradients(work.world, mobility);
    write_mobility(work.folder, std::array{&mobility});
}

} // namespace

void do_detach(StageWork& work, const erosion::DetachStageSpec& spec) {
    work.numbers["model"] = model_name(spec.probe.gravity.has_value());
    if (spec.probe.gravity) {
        return detach_with_weight(work, spec);
    }
    work.findings.probes = erosion::probe_gradients(work.world, spec, work.surroundings());
    json probes = json::array();
    for (const erosion::ProbeResult& probe : work.findings.probes) {
        probes.push_back(probe_numbers(probe));
        note_probe(work, spec.detached, probe, true);
        note_threshold(work, fmt::format("i = {}", short_number(probe.gradient)), spec.detached, probe);
    }
    work.numbers["probes"] = probes;
    const erosion::ProbeResult& first = work.findings.probes.front();
    work.numbers.update(source_numbers(first.flow));
    note_network(
        work, "of the sample", first.flow, dem::porosity(work.world), spec.probe.flow.solver == flow::Solver::Auto
    );
    const auto count = static_cast<std::int64_t>(work.findings.probes.size());
    work.time_step = first.time_step;
    work.numbers["steps"] = first.relax_steps + (count + 1) * (first.ramp + first.watch); // one twin serves all
    work.count_steps(work.numbers["steps"]);
}

void do_erode(StageWork& work, const erosion::ErodeSpec& spec) {
    erosion::ErosionResult& result = work.findings.erosion.emplace();
    bool goes_on = true;
    if (work.resumed.is_null()) {
        result = erosion::begin_erosion(work.world);
    } else {
        result = work.resumed.at("result").get<erosion::ErosionResult>();
        goes_on = work.resumed.at("goes_on");
    }
    const auto passes_done = [&] { return static_cast<int>(result.passes.size()); };
    while (goes_on && (spec.until_nothing_leaves || passes_done() < spec.passes)) {
        if (passes_done() > 0) { // the state between two passes; that after the last is the stage's own
            io::save_world(
                record::pass_file(work.folder, passes_done()), work.world, {},
                {{"case_hash", record::case_hash(work.what)},
                 {"stage", fmt::format("{}, pass {}", work.place(), passes_done())}}
            );
        }
        goes_on = take_pass([&] { return erosion::erode_once(work.world, spec, work.surroundings(), result); });
        work.history.record(work.world, true);
        work.save_partial({{"result", result}, {"goes_on", goes_on}});
    }
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
        if (pass.mobility) {
            note_mobility(work, fmt::format("pass {}: ", pass.pass), *pass.mobility);
        } else {
            const erosion::DetachSpec rule = erosion::at_pass(spec, pass.pass).detached;
            note_probe(work, rule, pass.probe, !spec.forced);
            if (!spec.forced) {
                note_threshold(work, fmt::format("pass {}", pass.pass), rule, pass.probe);
            }
        }
        const bool is_usual_end = pass.verdict == erosion::Ending{erosion::NothingLeaves{}} ||
                                  (pass.reached_target && !pass.failed && !erosion::doubt_skeleton(work.world));
        if (pass.verdict && !is_usual_end) {
            work.warnings.push_back(
                fmt::format("{}: pass {}: {}", work.place(), pass.pass, record::words_of(pass.verdict))
            );
        }
    }
    note_target(work, spec, result);
    if (!result.passes.empty()) {
        const erosion::PassResult& last = result.passes.back();
        const std::string when = fmt::format("after pass {}", last.pass);
        const bool would_resolve = spec.probe.flow.solver == flow::Solver::Auto;
        const erosion::PassResult& first = result.passes.front();
        note_network(work, "before pass 1", first.probe.flow, first.porosity_before, would_resolve);
        note_network(work, when, last.flow_after, last.porosity_after, would_resolve);
        note_closed_voids(work, when + ": ", last.closed_voids);
        note_fast_water(work, when, last.probe.gradient, last.reynolds_after, last.porosity_after);
    }
    keep_mobility(work, result);
    work.numbers["passes"] = passes;
    work.numbers["model"] = model_name(spec.probe.gravity && !spec.forced);
    for (const auto of : {erosion::ErodedTarget::Of::Fines, erosion::ErodedTarget::Of::Solids}) {
        work.numbers[fmt::format("eroded_share_of_{}", name_of(of))] =
            erosion::eroded_share(work.world, result.initial_mass, of);
    }
    work.numbers["steps"] = steps;
    write_eroded(work.folder, result);
    write_constrictions(work.folder, result);
    write_transport(work.folder, result);
}

} // namespace suffuse::run
