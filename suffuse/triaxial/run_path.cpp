#include "suffuse/triaxial/run_path.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/cell/hold_stress.hpp"
#include "suffuse/cell/strain.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/carried_stress.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/stats/coordination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace suffuse::triaxial {
namespace {

constexpr double creep_room = 1.1;   // axial strain until at rest, at most, over the largest during the test [-]
constexpr double fastest_held = 2;   // rate of an axis whose stress is held, at most, over the axial rate [-]
constexpr double least_ratio = 0.05; // q/p that a constant deviator needs, for servos to hold it [-]
constexpr double held_within = 0.02; // of its value, a constant deviator [-]
constexpr double first_pace = 0.01, quicker = 1.2, slower = 0.5;
constexpr double closed_a_burst = 0.5;  // of what is missing of the stress to stop at, at most [-]
constexpr double stops_within = 2.5e-3; // of the deviator stress to stop at, below it [-]
constexpr double less_patient = 1.1;    // of the least pace, from one slowed burst to the next [-]

double lateral_mean(const Mat3& stress, int axis) {
    return 0.5 * (trace(stress) - stress(axis, axis));
}

double deviator(const Mat3& stress, int axis) {
    return stress(axis, axis) - lateral_mean(stress, axis);
}

/// Volumetric over axial strain, where the path imposes it.
std::optional<double> imposed_strain_ratio(const TriaxialSpec& spec) {
    return spec.path == Path::Undrained ? std::optional(0.0) : spec.strain_ratio;
}

/// All stresses held, the lateral ones alike.
cell::Loading held_stresses(const TriaxialSpec& spec, double p, double q) {
    cell::Loading loading;
    loading.axis.fill({cell::Control::Stress, p - q / 3});
    loading.axis[static_cast<std::size_t>(spec.axis)].value = p + 2 * q / 3;
    return loading;
}

/// What drives the test, besides what is held.
cell::Loading loading_of(const TriaxialSpec& spec, const PathState& state) {
    using cell::Control;
    const Mat3 &start = state.start_stress, &now = state.balance.stress;
    const double rate = state.pace * state.strain_rate;
    cell::AxisControl axial{Control::StrainRate, rate}, lateral;
    if (const std::optional<double> ratio = imposed_strain_ratio(spec)) {
        lateral = {Control::StrainRate, -0.5 * (1 - *ratio) * rate};
    } else if (spec.path == Path::ConstantMean) {
        lateral = {Control::MeanStress, dem::mean_stress(start)};
    } else if (spec.path == Path::ConstantDeviator) {
        // A sample that fails flows at constant volume, with the axial rate of the other paths.
        lateral = {Control::StrainRate, -0.5 * rate};
        axial = {Control::Stress, lateral_mean(now, spec.axis) + deviator(start, spec.axis)};
    }
    cell::Loading loading;
    // A sample widens at half of its axial rate and its dilatancy together: the servo must be able to follow, but no
    // axis may be faster than quasi-static.
    loading.servo.max_rate = fastest_held * state.strain_rate;
    for (int a = 0; a < 3; ++a) {
        if (spec.path == Path::Drained) { // what each held at the start, which need not be the same
            lateral = {Control::Stress, start(a, a)};
        }
        loading.axis[static_cast<std::size_t>(a)] = a == spec.axis ? axial : lateral;
    }
    return loading;
}

/// Full, or on the way to it. At a constant deviator, before a sample fails its stresses fall so quickly that the axial
/// servo would lag behind: the cell waits for it.
void keep_pace(const TriaxialSpec& spec, PathState& state) {
    if (spec.path != Path::ConstantDeviator) {
        state.pace = std::min(1.0, quicker * state.pace);
        return;
    }
    const double q = deviator(state.start_stress, spec.axis);
    const double lag = std::abs(deviator(state.balance.stress, spec.axis) - q) / (held_within * q);
    if (lag > 1) {
        state.pace = std::max(first_pace, slower * state.pace);
    } else if (lag < 0.5) {
        state.pace = std::min(1.0, quicker * state.pace);
    }
}

/// The stresses to come to rest at: the specified one, and those held during the test.
cell::Loading final_loading(const TriaxialSpec& spec, const PathState& state) {
    if (imposed_strain_ratio(spec)) {
        return dem::constant_volume();
    }
    const double start_mean = dem::mean_stress(state.start_stress), start_q = deviator(state.start_stress, spec.axis);
    if (spec.path == Path::ConstantDeviator) {
        return held_stresses(spec, start_q / *spec.stress_ratio, start_q);
    }
    if (spec.path == Path::ConstantMean) {
        return held_stresses(spec, start_mean, *deviator_to_stop_at(spec, start_mean));
    }
    const double lateral = lateral_mean(state.start_stress, spec.axis);
    const double q = spec.deviator_stress ? *spec.deviator_stress // or q = eta p, with p = lateral + q/3
                                          : *spec.stress_ratio * lateral / (1 - *spec.stress_ratio / 3);
    cell::Loading loading = loading_of(spec, state);
    loading.axis[static_cast<std::size_t>(spec.axis)] = {cell::Control::Stress, lateral + q};
    return loading;
}

/// q that is missing of the one to stop at [Pa]; below zero beyond it, nothing where the test goes to a strain.
std::optional<double> missing_deviator(const TriaxialSpec& spec, const Mat3& stress) {
    const std::optional<double> wanted = deviator_to_stop_at(spec, dem::mean_stress(stress));
    return wanted ? std::optional(*wanted - deviator(stress, spec.axis)) : std::nullopt;
}

bool target_reached(const TriaxialSpec& spec, const PathRow& row) {
    const std::optional<double> wanted = deviator_to_stop_at(spec, row.mean_stress);
    return wanted && row.deviator_stress >= (1 - stops_within) * *wanted;
}

/// The less is missing of the stress to stop at, the more slowly the sample is loaded, so that it comes there from
/// below, and quasi-static: a burst closes half of the distance at most. Not for ever: what a sample that fails near
/// the specified stress closes is noise. @param closed by a burst of this pace [Pa]; a sample is no stiffer than its
/// network
void ease_to_target(const dem::World& world, const TriaxialSpec& spec, double pace, double closed, PathState& state) {
    const Vec3 modulus =
        contact::affine_moduli(world.grains, world.contacts, world.material, world.cell.h).longitudinal;
    const double full_burst = state.strain_rate * static_cast<double>(dem::burst_steps) * state.time_step;
    const double closing = std::min(closed / pace, modulus[spec.axis] * full_burst);
    const double to_close = closed_a_burst * *missing_deviator(spec, state.balance.stress);
    if (to_close < state.pace * closing) {
        state.pace = std::max(to_close / closing, state.least_pace);
        state.least_pace = std::min(1.0, less_patient * state.least_pace);
    }
}

/// How far the test has come [-]. At a constant deviator a sample widens and lengthens until it fails.
double progress(const TriaxialSpec& spec, const PathRow& row) {
    const double widening = spec.path == Path::ConstantDeviator ? row.axial_strain - row.volumetric_strain : 0;
    return std::max(row.axial_strain, widening);
}

bool holds_total_stress(Path path) {
    return path == Path::Undrained || path == Path::ConstantDeviator;
}

PathRow measure_row(const dem::World& world, const TriaxialSpec& spec, const PathState& state) {
    const Mat3& stress = state.balance.stress;
    PathRow row;
    row.axial_strain = cell::axial_strains(state.start_h, world.cell.h)[spec.axis];
    row.volumetric_strain = cell::volumetric_strain(state.start_h, world.cell.h);
    row.stress = stress;
    row.mean_stress = dem::mean_stress(stress);
    row.deviator_stress = deviator(stress, spec.axis);
    row.void_ratio = dem::void_ratio(world);
    const stats::Coordination coordination = stats::measure_coordination(world);
    row.coordination = coordination.mean;
    row.mechanical_coordination = coordination.mechanical;
    row.unbalanced_force = state.balance.equilibrium.unbalanced_force;
    const double rate = std::abs(world.cell.velocity_gradient(spec.axis, spec.axis));
    row.inertial_number = dem::inertial_number(rate, state.median_diameter, world.material.density, row.mean_stress);
    if (!state.rows.empty()) {
        row.second_order_work = second_order_work(state.rows.back(), row);
    }
    row.energy = (1 / determinant(state.start_h)) * state.energy.parts;
    if (holds_total_stress(spec.path)) { // laterally: water takes what grains no longer carry
        row.excess_pore_pressure = lateral_mean(state.start_stress, spec.axis) - lateral_mean(stress, spec.axis);
    }
    return row;
}

[[noreturn]] void report_out_of_reach(const PathRow& row) {
    throw StateError(fmt::format(
        "the triaxial test cannot reach the specified stress: at {:.3g} % axial strain the deviator stress is {:.4g} "
        "kPa (q/p = {:.3f}); specify less than the peak of this sample",
        100 * row.axial_strain, row.deviator_stress / 1e3, row.deviator_stress / row.mean_stress
    ));
}

/// A sample that cannot carry the stress goes on straining, or never comes to rest.
void check_settling(
    const dem::World& world, const TriaxialSpec& spec, const dem::BalanceSpec& balance, const PathState& state
) {
    const PathRow row = measure_row(world, spec, state);
    if (progress(spec, row) > creep_room * std::max(spec.strain, progress(spec, state.rows.back()))) {
        report_out_of_reach(row);
    }
    if (state.balance.steps >= dem::SettleSpec{}.max_steps) {
        dem::report_not_balanced(final_loading(spec, state), balance, state.balance, "");
    }
}

void check_spec(const TriaxialSpec& spec) {
    if (!(spec.strain > 0) || !(spec.inertial_number > 0) || spec.rows < 1) {
        throw CaseError(fmt::format(
            "triaxial: found strain {}, inertial_number {}, rows {}; expected all of them above 0", spec.strain,
            spec.inertial_number, spec.rows
        ));
    }
    if (spec.strain_ratio.has_value() != (spec.path == Path::Proportional)) {
        throw CaseError("triaxial: strain_ratio belongs to the path \"proportional\", and is needed there");
    }
    if (spec.deviator_stress && spec.stress_ratio) {
        throw CaseError("triaxial: found a deviator_stress and a stress_ratio to stop at; keep one of them");
    }
    if (spec.path == Path::ConstantDeviator && spec.deviator_stress) {
        throw CaseError("triaxial: the path \"constant-deviator\" holds q; give stress_ratio instead of deviator_stress"
        );
    }
}

double choose_time_step(const dem::World& world, const TriaxialSpec& spec, double damping) {
    return spec.time_step > 0 ? spec.time_step : dem::stable_time_step(world, {damping});
}

/// Later stages hold the lateral stresses of a drained test, else the stresses that the test has led to.
void end_path(dem::World& world, const TriaxialSpec& spec, PathState& state) {
    const bool holds_lateral = spec.path == Path::Drained;
    cell::hold_stress(holds_lateral ? loading_of(spec, state) : dem::constant_volume(), world.servo);
    state.phase = PathState::Phase::Done;
}

} // namespace

std::optional<double> deviator_to_stop_at(const TriaxialSpec& spec, double mean_stress) {
    return spec.stress_ratio ? std::optional(*spec.stress_ratio * mean_stress) : spec.deviator_stress;
}

dem::Lent lent_during(const TriaxialSpec& spec, const grains::Material& material) {
    const bool lends = spec.inertia == GrainInertia::Lent && spec.time_step <= 0 && spec.path != Path::ConstantDeviator;
    return {lends, lends && material.friction > 0};
}

double strain_rate_of(const TriaxialSpec& spec, const grains::Material& material, double median, double pressure) {
    const double slower = lent_during(spec, material).rotation ? dem::slower_turning : 1;
    return dem::rate_of_inertial_number(spec.inertial_number / slower, median, material.density, pressure);
}

PathState begin_path(dem::World& world, const TriaxialSpec& spec, const Mat3& stress) {
    check_spec(spec);
    const double pressure = dem::require_pressure(stress, "a triaxial test needs a sample");
    const double q = deviator(stress, spec.axis);
    if (spec.path == Path::ConstantDeviator && !(q >= least_ratio * pressure)) {
        throw StateError(fmt::format(
            "a path at constant deviator stress holds the one that the sample starts with, and this one's is {:.4g} "
            "kPa at a mean stress of {:.4g} kPa: shear it first, as with stress_ratio = 0.5",
            q / 1e3, pressure / 1e3
        ));
    }
    PathState state;
    state.start_h = world.cell.h;
    state.start_stress = stress;
    state.balance.stress = stress;
    state.median_diameter = grains::median_diameter(world.grains);
    state.strain_rate = strain_rate_of(spec, world.material, state.median_diameter, pressure);
    state.pace = spec.path == Path::ConstantDeviator ? first_pace : 1;
    state.lent = lent_during(spec, world.material);
    dem::lend_inertia(world, state.median_diameter, {}, state.lent);
    state.balance.equilibrium = dem::measure_equilibrium(world);
    state.energy = dem::begin_balance(world, state.balance);
    state.rows.push_back(measure_row(world, spec, state));
    return state;
}

bool path_burst(
    dem::World& world, dem::StepCaches& caches, const TriaxialSpec& spec, const dem::BalanceSpec& balance,
    double damping, dem::Mode mode, PathState& state
) {
    dem::renew_time_step(state, state.steps, state.balance.equilibrium.contacts, [&] {
        return choose_time_step(world, spec, damping);
    });
    const std::optional<double> missing = missing_deviator(spec, state.balance.stress);
    if (missing && state.steps == 0) {
        ease_to_target(world, spec, 1, std::numeric_limits<double>::infinity(), state);
    }
    const bool settling = state.phase == PathState::Phase::Settle;
    dem::StepPlan plan;
    plan.dt = state.time_step;
    plan.damping = damping;
    plan.mode = mode;
    plan.loading = settling ? final_loading(spec, state) : loading_of(spec, state);
    const bool settled = dem::settle_burst(world, caches, plan, balance, state.balance);
    state.steps += dem::burst_steps;
    if (settling) {
        if (settled) {
            end_path(world, spec, state);
        } else {
            check_settling(world, spec, balance, state);
        }
        return settled;
    }
    const double pace = state.pace;
    keep_pace(spec, state);
    if (missing) {
        ease_to_target(world, spec, pace, *missing - *missing_deviator(spec, state.balance.stress), state);
    }
    dem::follow(state.energy, world, state.balance, state.time_step, damping);
    const PathRow row = measure_row(world, spec, state);
    const bool reached = target_reached(spec, row);
    const double now = progress(spec, row);
    const bool over = reached || now >= spec.strain;
    if (over || now - progress(spec, state.rows.back()) >= spec.strain / spec.rows) {
        state.rows.push_back(row);
    }
    if (!over) {
        return false;
    }
    if (missing && !reached) {
        report_out_of_reach(row);
    }
    state.balance.steps = state.balance.balanced_steps = 0;
    give_back(world, state); // a balance is proved with the grains' own inertia
    if (reached) {
        dem::take_time_step(state, choose_time_step(world, spec, damping), state.balance.equilibrium.contacts);
        state.phase = PathState::Phase::Settle;
    } else {
        end_path(world, spec, state);
    }
    return !reached;
}

void give_back(dem::World& world, PathState& state) {
    dem::lend_inertia(world, state.median_diameter, state.lent, {});
    state.lent = {};
}

double second_order_work(const PathRow& before, const PathRow& after) {
    const double volumetric = after.volumetric_strain - before.volumetric_strain;
    const double shear = after.axial_strain - before.axial_strain - volumetric / 3;
    return (after.mean_stress - before.mean_stress) * volumetric +
           (after.deviator_stress - before.deviator_stress) * shear;
}

} // namespace suffuse::triaxial
