// The verbs with water: flow, detach.

#include "suffuse/base/words.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/detachment.hpp"
#include "suffuse/erosion/weighed_probe.hpp"
#include "suffuse/facts/pass.hpp"
#include "suffuse/flow/pore_velocity.hpp"
#include "suffuse/flow/reynolds.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/flow/throat_flux.hpp"
#include "suffuse/io/flow_tables.hpp"
#include "suffuse/io/tables.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/run/grain_pictures.hpp"
#include "suffuse/run/mobility_record.hpp"
#include "suffuse/run/note_threshold.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/run/water_notes.hpp"
#include "suffuse/run/water_numbers.hpp"
#include "suffuse/stokes/water.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace suffuse::run {
namespace {

using nlohmann::json;

/// Root of the mean square difference of the network's forces to the resolved ones, over that of these; null at rest.
json force_difference(const std::vector<Vec3>& network, const std::vector<Vec3>& resolved) {
    double difference = 0, size = 0;
    for (std::size_t g = 0; g < resolved.size(); ++g) {
        difference += norm2(network[g] - resolved[g]);
        size += norm2(resolved[g]);
    }
    return or_null(std::sqrt(difference / size));
}

/// The flow between the grains themselves, next to that of the network.
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
    numbers.update(record::facts_json(facts::flow_source, source));
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
        {"set_up", seepage.seconds.set_up},
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
    work.pictured.push_back(picture_column("fluid_force", water.grain_force()));
    if (record::writes(work.what.output, "vtp")) {
        io::write_pores_vtu(
            work.folder / "pores.vtu", seepage.network, grains.position, seepage.field.pressure, velocity
        );
    }
}

namespace {

/// The curve as far as it is known: rows of `mobility` in stage.json, and the row of the gradient that is held.
json ramp_to_show(std::span<const erosion::MobilityStep> kept, const erosion::MobilityStep& held) {
    const auto point = [](const erosion::MobilityStep& step) -> json {
        return {{"gradient", step.gradient}, {"mobile_mass_share", step.mobile_mass_share}};
    };
    json rows = json::array();
    for (const erosion::MobilityStep& step : kept) {
        rows.push_back(point(step));
    }
    return {{"mobility", rows}, {"held", point(held)}};
}

void detach_with_weight(StageWork& work, const erosion::DetachStageSpec& spec) {
    const erosion::WatchRamp watch = [&](std::span<const erosion::MobilityStep> kept, const erosion::MobilityStep& held
                                     ) { work.control.show_numbers(ramp_to_show(kept, held)); };
    const erosion::Surroundings around = work.surroundings();
    erosion::MobilityRamp ramp;
    if (work.resumed.is_null()) {
        ramp = erosion::begin_detach(work.world, spec, around);
    } else {
        ramp = work.resumed.at("ramp").get<erosion::MobilityRamp>();
        ramp.world = std::exchange(work.world, std::move(work.start).value());
    }
    work.control.save_with([&] { work.save_partial({{"ramp", ramp}}, ramp.world); });
    while (!ramp.over) {
        erosion::climb(ramp, spec, around, watch);
    }
    const erosion::MobilityResult& mobility = work.findings.mobility.emplace(erosion::detached(ramp, work.world, spec));
    work.numbers.update(mobility_numbers(mobility));
    work.numbers.update(record::facts_json(facts::flow_source, mobility.flow));
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
        probes.push_back(record::facts_json(facts::probe, probe));
        note_probe(work, spec.detached, probe, true);
        note_threshold(work, fmt::format("i = {}", short_number(probe.gradient)), spec.detached, probe);
    }
    work.numbers["probes"] = probes;
    work.pictured = probe_columns(work.world, work.findings.probes.back());
    const erosion::ProbeResult& first = work.findings.probes.front();
    work.numbers.update(record::facts_json(facts::flow_source, first.flow));
    note_network(
        work, "of the sample", first.flow, dem::porosity(work.world), spec.probe.flow.solver == flow::Solver::Auto
    );
    const auto count = static_cast<std::int64_t>(work.findings.probes.size());
    work.time_step = first.time_step;
    work.numbers["steps"] = first.relax_steps + (count + 1) * (first.ramp + first.watch); // one twin serves all
    work.count_steps(work.numbers["steps"]);
}

} // namespace suffuse::run
