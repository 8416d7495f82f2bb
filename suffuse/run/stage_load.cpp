// The verbs that load a sample: settle, laboratory tests, stress-probe, stiffness, advance.

#include "suffuse/dem/drive_world.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/facts/test.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/result_json.hpp"
#include "suffuse/run/laboratory_numbers.hpp"
#include "suffuse/run/measure.hpp"
#include "suffuse/run/stage_work.hpp"
#include "suffuse/triaxial/stress_probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::run {
namespace {

/// @param time_step requested [s]; 0: computed
dem::StepPlan plan_for(const StageWork& work, double time_step, const cell::Loading& loading) {
    dem::StepPlan plan;
    plan.dt = time_step;
    plan.damping = work.variant.damping;
    plan.mode = work.what.mode;
    plan.loading = loading;
    return plan;
}

/// A sample that strains by itself answers to no load.
void note_drift(StageWork& work, double drift, const std::vector<triaxial::StressProbe>& probes) {
    constexpr double much = 0.1;
    double least = std::numeric_limits<double>::infinity();
    for (const triaxial::StressProbe& probe : probes) {
        least = std::min(least, norm(probe.strain));
    }
    if (drift > much * least) {
        work.warnings.push_back(fmt::format(
            "{}: without load the sample strains by {:.1e}, under the loads by {:.1e} and more: take a larger "
            "increment, or a smaller unbalanced_force",
            work.place(), drift, least
        ));
    }
}

/// A quasi-static test leaves the calculation's own damping nothing to do, and its work is accounted for. One in which
/// the sample gave way is neither.
void note_energy(StageWork& work, const triaxial::TriaxialSpec& spec, const triaxial::Response& response) {
    constexpr double much_damping = 0.1, much_unaccounted = 0.05; // of what is taken
    const bool gives_way =
        spec.path == triaxial::Path::ConstantDeviator || response.lost_at || response.liquefied.value_or(false);
    const dem::EnergyParts& energy = response.energy;
    const double taken = energy.slip + energy.rolling + energy.damping;
    if (gives_way) {
        return;
    }
    if (energy.damping > much_damping * taken) {
        work.warnings.push_back(fmt::format(
            "{}: local damping takes {:.2g} % of what the test dissipates, which a soil leaves to slip and rolling: "
            "take a smaller inertial_number",
            work.place(), 100 * energy.damping / taken
        ));
    }
    const double turned_over = std::max(taken, energy.work); // before yield most of the work is in springs
    if (std::abs(energy.unaccounted()) > much_unaccounted * turned_over) {
        work.warnings.push_back(fmt::format(
            "{}: springs, motion, slip, rolling and damping leave {:.2g} % of the energy of the test unaccounted for",
            work.place(), 100 * energy.unaccounted() / turned_over
        ));
    }
}

/// A sample that came to the specified stress from beyond it is not the one that was requested: where it was unloaded,
/// its contacts are off their limits; where its volume was held, it bears more.
void note_overshoot(StageWork& work, const triaxial::TriaxialSpec& spec, const std::vector<triaxial::PathRow>& rows) {
    constexpr double much = 0.01;
    const triaxial::PathRow& stop = rows.back();
    const double specified =
        triaxial::deviator_to_stop_at(spec, stop.mean_stress).value_or(std::abs(stop.deviator_stress));
    const double allowed = std::max(much * specified, work.what.balance.stress_error * rows.front().mean_stress);
    if (spec.sense() * stop.deviator_stress > specified + allowed) {
        const auto ratio_text = [&](const triaxial::PathRow& row) {
            return spec.stress_ratio ? row.deviator_stress / row.mean_stress : row.deviator_stress / 1e3;
        };
        work.warnings.push_back(fmt::format(
            "{}: specified to stop at {}, the test started at {:.4g} and reached {:.4g}{}: the sample comes to rest "
            "after exceeding the specified stress, so its contacts are further from sliding than under first loading; "
            "start from a sample that bears less, or use a smaller inertial_number",
            work.place(),
            spec.stress_ratio ? fmt::format("q/p = {:.4g}", *spec.stress_ratio)
                              : fmt::format("a deviator stress of {:.4g} kPa", specified / 1e3),
            ratio_text(rows.front()), ratio_text(stop), spec.stress_ratio ? "" : " kPa"
        ));
    }
}

/// What fills the voids of an undrained test, where the case says how far it can be compressed.
std::optional<triaxial::PoreFluid> fluid_in(StageWork& work, const triaxial::TriaxialSpec& spec) {
    if (!work.what.fluid.bulk_modulus || spec.path != triaxial::Path::Undrained) {
        return std::nullopt;
    }
    const Pulse pulse = [&](std::string_view part, long long steps) { work.control.beat(part, steps); };
    return triaxial::PoreFluid{
        *work.what.fluid.bulk_modulus, triaxial::measure_skeleton_modulus(work.world, work.variant.damping, pulse)};
}

} // namespace

void do_settle(StageWork& work, const dem::SettleSpec& spec) {
    dem::Settling settling;
    if (work.resumed.is_null()) {
        settling = dem::begin_settling(work.world);
        dem::sort_along_curve(work.world);
    } else {
        settling.balance = work.resumed.at("balance").get<dem::BalanceState>();
        settling.time_step = work.resumed.at("time_step");
        settling.known_contacts = work.resumed.at("known_contacts");
        settling.stress_before = work.resumed.at("stress_before");
    }
    work.control.save_with([&] {
        work.save_partial(
            {{"balance", settling.balance},
             {"time_step", settling.time_step},
             {"known_contacts", settling.known_contacts},
             {"stress_before", settling.stress_before}}
        );
    });
    dem::StepCaches caches;
    const dem::StepPlan plan = plan_for(work, spec.time_step, spec.loading);
    dem::settle_world(work.world, caches, plan, work.what.balance, spec.max_steps, settling, [&](bool is_over) {
        work.count_steps(dem::burst_steps);
        work.note_state();
        if (!is_over) {
            work.control.beat("settle", settling.balance.steps, &work.world);
        }
    });
    if (settling.collapsed) {
        work.warnings.push_back(fmt::format(
            "{}: the sample carries no stress at this volume: its grains are not held together", work.place()
        ));
    }
    work.time_step = settling.time_step;
    work.numbers["steps"] = settling.balance.steps;
}

void do_triaxial(StageWork& work, const triaxial::TriaxialSpec& spec) {
    triaxial::PathState state;
    if (work.resumed.is_null()) {
        dem::sort_along_curve(work.world);
        state = triaxial::begin_path(work.world, spec, dem::mean_stress_tensor(work.world), fluid_in(work, spec));
    } else {
        state = work.resumed.get<triaxial::PathState>();
    }
    work.control.show_strain_of(spec.axis);
    work.control.save_with([&] { work.save_partial(state); });
    dem::StepCaches caches;
    bool over = false;
    while (!over) {
        over = triaxial::path_burst(
            work.world, caches, spec, work.what.balance, work.variant.damping, work.what.mode, state
        );
        work.count_steps(dem::burst_steps);
        work.note_state();
        if (!over) {
            work.control.beat("shear", state.steps, &work.world);
        }
    }
    work.time_step = state.time_step;
    work.numbers["steps"] = state.steps;
    work.numbers["strain_rate"] = state.strain_rate;
    if (spec.path == triaxial::Path::Undrained) {
        work.numbers["skempton_b"] = state.skempton_b;
    }
    work.numbers["inertia"] = triaxial::lent_during(spec, work.world.material).mass ? "lent" : "own";
    const triaxial::Response response = triaxial::summarize(state.rows, spec);
    if (response.lost_at) {
        work.flaws.push_back(fmt::format(
            "{}: at {:.2g} % axial strain the stress that this path holds was lost, for the sample gave way faster "
            "than a quasi-static servo may follow: it collapses under such loads, and the rows from there on are no "
            "test of it",
            work.place(), 100 * *response.lost_at
        ));
    }
    if (nlohmann::json numbers = laboratory_numbers(spec, state.rows); numbers.empty()) {
        work.numbers["response"] = response;
    } else {
        work.numbers.update(numbers);
        work.numbers["energy"] = response.energy;
    }
    if (const std::string words = words_on_hold(state.rows, spec); !words.empty()) {
        work.flaws.push_back(work.place() + ": " + words);
    }
    note_energy(work, spec, response);
    note_overshoot(work, spec, state.rows);
    work.findings.curve = state.rows;
}

void do_stress_probe(StageWork& work, const triaxial::StressProbeSpec& spec) {
    std::vector<triaxial::StressProbe> probes;
    if (!work.resumed.is_null()) {
        probes = work.resumed.at("probes").get<std::vector<triaxial::StressProbe>>();
    }
    work.control.save_with([&] { work.save_partial({{"probes", probes}}); });
    std::int64_t steps = 0; // of rest and of the probes that are over
    const Pulse pulse = [&](std::string_view part, long long now) { work.control.beat(part, steps + now); };
    const triaxial::ProbedState state = triaxial::rest_for_probes(work.world, spec, work.variant.damping, pulse);
    steps = state.steps;
    for (const triaxial::StressProbe& probe : probes) {
        steps += probe.steps;
    }
    while (std::ssize(probes) < spec.directions) {
        const auto number = static_cast<int>(probes.size());
        probes.push_back(triaxial::probe_direction(state, spec, number, work.variant.damping, pulse));
        steps += probes.back().steps;
    }
    work.time_step = state.time_step;
    work.grain_steps = steps * static_cast<std::int64_t>(work.world.grains.size());
    work.numbers["steps"] = steps;
    work.numbers["stress_probed"] = state.stress;
    work.numbers["drift"] = state.drift;
    work.numbers["stress_probes"] = probes;
    note_drift(work, state.drift, probes);
}

void do_stiffness(StageWork& work, const triaxial::StiffnessSpec& spec) {
    std::vector<triaxial::StrainProbe> probes;
    if (!work.resumed.is_null()) {
        probes = work.resumed.at("probes").get<std::vector<triaxial::StrainProbe>>();
    }
    work.control.save_with([&] { work.save_partial({{"probes", probes}}); });
    std::int64_t steps = 0; // of rest and of the strains that are over
    const Pulse pulse = [&](std::string_view part, long long now) { work.control.beat(part, steps + now); };
    triaxial::RestedState state = triaxial::rest_for_strains(work.world, spec, work.variant.damping, pulse);
    steps = state.steps;
    for (const triaxial::StrainProbe& probe : probes) {
        steps += probe.steps;
    }
    while (std::ssize(probes) < triaxial::strain_directions) {
        const Mat3 direction = triaxial::strain_direction(static_cast<int>(probes.size()));
        probes.push_back(triaxial::probe_strain(state, spec, direction, work.variant.damping, pulse));
        steps += probes.back().steps;
    }
    work.time_step = state.time_step;
    work.grain_steps = steps * static_cast<std::int64_t>(work.world.grains.size());
    work.numbers["steps"] = steps;
    const triaxial::Stiffness stiffness = triaxial::stiffness_of(state, probes);
    record::put_facts(work.numbers, facts::stiffness, stiffness);
    if (const std::optional<double> fluid = work.what.fluid.bulk_modulus) {
        const double porosity = dem::porosity(work.world);
        work.numbers["skempton_b"] = triaxial::skempton_b(porosity, {*fluid, stiffness.bulk_modulus});
    }
    if (const std::string words = words_on_stiffness(stiffness, spec); !words.empty()) {
        work.flaws.push_back(work.place() + ": " + words);
    }
}

void do_advance(StageWork& work, const dem::AdvanceSpec& spec) {
    dem::Advancing advancing;
    if (work.resumed.is_null()) {
        work.history.record(work.world, true);
    } else {
        advancing.done = work.resumed.at("done");
        advancing.time_step = work.resumed.at("time_step");
        advancing.known_contacts = work.resumed.at("known_contacts");
    }
    work.control.save_with([&] {
        work.save_partial(
            {{"done", advancing.done}, {"time_step", advancing.time_step}, {"known_contacts", advancing.known_contacts}}
        );
    });
    dem::StepCaches caches;
    dem::advance_world(
        work.world, caches, plan_for(work, spec.time_step, spec.loading), spec.steps, advancing,
        [&] { return work.history.steps_to_next(work.world.clock.step); },
        [&](std::int64_t steps) {
            work.count_steps(steps);
            work.note_state();
            if (advancing.done < spec.steps) {
                work.control.beat("advance", advancing.done, &work.world);
            }
        }
    );
    work.time_step = advancing.time_step;
    work.numbers["steps"] = advancing.done;
}

} // namespace suffuse::run
