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
#include "suffuse/triaxial/path_loading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace suffuse::triaxial {
namespace {

constexpr double creep_room = 1.1;   // axial strain until at rest, at most, over the largest during the test [-]
constexpr double least_ratio = 0.05; // q/p that a constant deviator needs, for servos to hold it [-]
constexpr double held_within = 0.01; // of its value, a stress: else the cell waits for the servo [-]
constexpr double flow_within = 0.02; // likewise, a constant deviator [-]
constexpr double most_delay = 20;    // intervals of rows, until a row shows a stress that is not held
constexpr double first_pace = 0.01, quicker = 1.2, slower = 0.5;
constexpr double closed_a_burst = 0.5;  // of what is missing of the stress to stop at, at most [-]
constexpr double stops_within = 2.5e-3; // of what a leg goes to, before it [-]
constexpr double less_patient = 1.1;    // of the least pace, from one slowed burst to the next [-]
constexpr double rows_a_leg = 40;       // of a test that turns
constexpr double stiffest = 3;          // axial modulus of isotropic compression over the longitudinal one, at most [-]

/// Full, or on the way to it. Where stresses change so quickly that the servo would lag behind, the cell waits for it:
/// at the start, while grains rearrange, and at a constant deviator before a sample fails.
void keep_pace(const TriaxialSpec& spec, PathState& state) {
    const double lag = hold_error(spec, state) / (spec.path == Path::ConstantDeviator ? flow_within : held_within);
    if (lag > 1) {
        state.pace = std::max(first_pace, slower * state.pace);
    } else if (lag < 0.5) {
        state.pace = std::min(1.0, quicker * state.pace);
    }
}

bool is_reached(const Target& target) {
    return target.missing <= stops_within * target.size;
}

double axial_strain_of(const dem::World& world, const TriaxialSpec& spec, const PathState& state) {
    return cell::axial_strains(state.start_h, world.cell.h)[spec.axis];
}

/// What is missing of the target of the leg, for now.
std::optional<Target> target_now(const dem::World& world, const TriaxialSpec& spec, const PathState& state) {
    return target_of(spec, state, state.balance.stress, axial_strain_of(world, spec, state));
}

/// The less is missing of the target, the more slowly the sample is loaded, so that it comes there from below, and
/// quasi-static: a burst closes half of the distance at most. Not for ever: what a sample that fails near the specified
/// stress closes is noise. @param closed by a burst of this pace; a sample is no stiffer than its network
void ease_to_target(
    const dem::World& world, const TriaxialSpec& spec, double pace, double closed, const Target& target,
    PathState& state
) {
    double closing = state.strain_rate * static_cast<double>(dem::burst_steps) * state.time_step;
    if (target.is_stress) {
        const Vec3 modulus =
            contact::affine_moduli(world.grains, world.contacts, world.material, world.cell.h).longitudinal;
        const double sides = spec.path == Path::Isotropic ? stiffest : 1;
        closing = std::min(closed / pace, sides * modulus[spec.axis] * closing);
    }
    const double to_close = closed_a_burst * target.missing;
    if (to_close < state.pace * closing) {
        state.pace = std::max(to_close / closing, state.least_pace);
        state.least_pace = std::min(1.0, less_patient * state.least_pace);
    }
}

/// Whether the test goes from one stress, or one turn of its load, to the next.
bool has_legs(const TriaxialSpec& spec) {
    return spec.cycles || !spec.stresses.empty();
}

/// How far the test has come [-]. At a constant deviator a sample widens and lengthens until it fails.
double progress(const TriaxialSpec& spec, const PathRow& row) {
    if (shears(spec.path)) {
        return row.shear_strain;
    }
    if (has_legs(spec)) {
        return std::abs(row.axial_strain);
    }
    const double widening = spec.path == Path::ConstantDeviator ? row.axial_strain - row.volumetric_strain : 0;
    return std::max(spec.sense() * row.axial_strain, widening);
}

/// Intervals of rows since the one before: of equal strain, and where a test turns also of what it turns at.
double rows_due(const TriaxialSpec& spec, const PathState& state, const PathRow& row) {
    const PathRow& last = state.rows.back();
    if (!has_legs(spec)) {
        return (progress(spec, row) - progress(spec, last)) * spec.rows / spec.strain;
    }
    const auto missing = [&](const PathRow& of) { return target_of(spec, state, of.stress, of.axial_strain)->missing; };
    const double strained = std::abs(row.axial_strain - last.axial_strain) * spec.rows / spec.strain;
    const double leg = missing(state.turn);
    return std::max(strained, leg > 0 ? rows_a_leg * std::abs(missing(last) - missing(row)) / leg : 0);
}

/// A row is a state under the stresses that the test holds: one that is due waits for them, but not for ever.
bool is_fit_for_row(const TriaxialSpec& spec, const PathRow& row, double due) {
    return row.hold_error <= held_within || spec.path == Path::ConstantDeviator || due >= most_delay;
}

/// Laterally: water takes what grains no longer carry; in simple shear, along the normal of what slides.
double excess_pore_pressure(const TriaxialSpec& spec, const Mat3& start, const Mat3& now) {
    if (spec.path == Path::ShearAtVolume) {
        return start(spec.shear_axes.normal, spec.shear_axes.normal) -
               now(spec.shear_axes.normal, spec.shear_axes.normal);
    }
    const bool holds_total_stress = spec.path == Path::Undrained || spec.path == Path::ConstantDeviator;
    return holds_total_stress ? lateral_mean(start, spec.axis) - lateral_mean(now, spec.axis) : 0;
}

/// The volume follows what the pore pressure compresses of the water. The skeleton answers a strain with less pore
/// pressure, so a burst closes the share B of what is missing: then it is closed but for the skeleton's anisotropy.
void compress_water(const dem::World& world, const TriaxialSpec& spec, PathState& state) {
    if (state.storage > 0) {
        const double pressure = excess_pore_pressure(spec, state.start_stress, state.balance.stress);
        const double missing = state.storage * pressure - cell::volumetric_strain(state.start_h, world.cell.h);
        const double most = fastest_held * state.strain_rate;
        const double rate = state.skempton_b * missing / (static_cast<double>(dem::burst_steps) * state.time_step);
        state.water_rate = std::clamp(rate, -most, most);
    }
}

PathRow measure_row(const dem::World& world, const TriaxialSpec& spec, const PathState& state) {
    const Mat3& stress = state.balance.stress;
    PathRow row;
    row.axial_strain = axial_strain_of(world, spec, state);
    row.volumetric_strain = cell::volumetric_strain(state.start_h, world.cell.h);
    row.stress = stress;
    row.mean_stress = dem::mean_stress(stress);
    row.deviator_stress = deviator(stress, spec.axis);
    row.void_ratio = dem::void_ratio(world);
    const stats::Coordination coordination = stats::measure_coordination(world);
    row.coordination = coordination.mean;
    row.mechanical_coordination = coordination.mechanical;
    row.unbalanced_force = state.balance.equilibrium.unbalanced_force;
    row.hold_error = hold_error(spec, state);
    const auto [normal, along] = shears(spec.path) ? spec.shear_axes : ShearAxes{spec.axis, spec.axis};
    const double rate = std::abs(world.cell.velocity_gradient(along, normal));
    row.inertial_number = dem::inertial_number(rate, state.median_diameter, world.material.density, row.mean_stress);
    if (!state.rows.empty() && is_axisymmetric(spec)) {
        row.second_order_work = second_order_work(state.rows.back(), row);
    }
    row.energy = (1 / determinant(state.start_h)) * state.energy.parts;
    row.excess_pore_pressure = excess_pore_pressure(spec, state.start_stress, stress);
    row.shear_strain = shears(spec.path) ? (world.cell.h * inverse(state.start_h))(along, normal) : 0;
    row.leg = state.leg;
    return row;
}

[[noreturn]] void report_out_of_reach(const TriaxialSpec& spec, const PathState& state, const PathRow& row) {
    if (!spec.stresses.empty()) {
        throw StateError(fmt::format(
            "the test cannot reach the specified stress of {:.4g} kPa: at {:.3g} % axial strain the axial stress is "
            "{:.4g} kPa; specify one that is nearer, or more `strain`",
            spec.stresses[static_cast<std::size_t>(state.leg)] / 1e3, 100 * row.axial_strain,
            row.stress(spec.axis, spec.axis) / 1e3
        ));
    }
    throw StateError(fmt::format(
        "the test cannot reach the specified stress: at {:.3g} % axial strain the deviator stress is {:.4g} kPa (q/p = "
        "{:.3f}); specify less than the peak of this sample, or more strain",
        100 * row.axial_strain, row.deviator_stress / 1e3, row.deviator_stress / row.mean_stress
    ));
}

/// A sample that cannot carry the stress goes on straining, or never comes to rest.
void check_settling(
    const dem::World& world, const TriaxialSpec& spec, const dem::BalanceSpec& balance, const PathState& state
) {
    const PathRow row = measure_row(world, spec, state);
    if (progress(spec, row) > creep_room * std::max(spec.strain, progress(spec, state.rows.back()))) {
        report_out_of_reach(spec, state, row);
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
    if (spec.b && (spec.path != Path::Drained || spec.stops_at_stress())) {
        throw CaseError("triaxial: b belongs to a drained test to a strain");
    }
    if (spec.direction == Direction::Extension && spec.path == Path::ConstantDeviator) {
        throw CaseError("triaxial: a path that holds the deviator stress has no direction; leave it out");
    }
    if (spec.cycles && spec.cycles->csr.has_value() == spec.cycles->strain.has_value()) {
        throw CaseError("cyclic: expected one amplitude; give either csr or strain_amplitude");
    }
    if (spec.path == Path::ConstantDeviator && spec.deviator_stress) {
        throw CaseError("triaxial: the path \"constant-deviator\" holds q; give stress_ratio instead of deviator_stress"
        );
    }
}

double choose_time_step(const dem::World& world, const TriaxialSpec& spec, double damping) {
    return spec.time_step > 0 ? spec.time_step : dem::stable_time_step(world, {damping});
}

/// Later stages hold the stresses that the test has held each for itself, else those that it has led to.
void end_path(dem::World& world, const TriaxialSpec& spec, PathState& state) {
    const bool holds = spec.path == Path::Drained || spec.path == Path::PlaneStrain || spec.path == Path::ShearAtStress;
    cell::hold_stress(holds ? loading_of(spec, state) : dem::constant_volume(), world.servo);
    state.phase = PathState::Phase::Done;
}

void turn(const TriaxialSpec& spec, const PathRow& row, PathState& state) {
    ++state.leg;
    state.sense = sense_of_leg(spec, state.leg, row.stress);
    state.least_pace = PathState{}.least_pace;
    state.turn = row;
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

double shear_stress(const TriaxialSpec& spec, const Mat3& stress) {
    const auto [normal, along] = spec.shear_axes;
    return -0.5 * (stress(along, normal) + stress(normal, along)); // compression is positive in the tensor
}

bool has_liquefied(const TriaxialSpec& spec, const PathState& state, const PathRow& row) {
    const double lateral = lateral_mean(state.start_stress, spec.axis);
    return row.excess_pore_pressure >= spec.cycles->pore_pressure_ratio * lateral ||
           std::abs(row.axial_strain - state.turn.axial_strain) >= spec.cycles->double_amplitude;
}

PathState
begin_path(dem::World& world, const TriaxialSpec& spec, const Mat3& stress, const std::optional<PoreFluid>& fluid) {
    check_spec(spec);
    const double pressure = dem::require_pressure(world, stress, "a laboratory test needs a sample");
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
    if (fluid && spec.path == Path::Undrained) {
        const double porosity = dem::porosity(world);
        state.storage = porosity / fluid->bulk_modulus;
        state.skempton_b = skempton_b(porosity, *fluid);
    }
    state.strain_rate = strain_rate_of(spec, world.material, state.median_diameter, pressure);
    state.sense = sense_of_leg(spec, 0, stress);
    state.pace = cell::holds_stress(loading_of(spec, state)) ? first_pace : 1;
    state.lent = lent_during(spec, world.material);
    dem::lend_inertia(world, state.median_diameter, {}, state.lent);
    state.balance.equilibrium = dem::measure_equilibrium(world);
    state.energy = dem::begin_balance(world, state.balance);
    state.rows.push_back(measure_row(world, spec, state));
    state.turn = state.rows.back();
    return state;
}

bool path_burst(
    dem::World& world, dem::StepCaches& caches, const TriaxialSpec& spec, const dem::BalanceSpec& balance,
    double damping, dem::Mode mode, PathState& state
) {
    dem::renew_time_step(state, state.steps, state.balance.equilibrium.contacts, [&] {
        return choose_time_step(world, spec, damping);
    });
    const std::optional<Target> target = target_now(world, spec, state);
    if (target && state.steps == 0) {
        ease_to_target(world, spec, 1, std::numeric_limits<double>::infinity(), *target, state);
    }
    const bool settling = state.phase == PathState::Phase::Settle;
    compress_water(world, spec, state);
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
    bool reached = false;
    if (target) {
        const Target now = *target_now(world, spec, state);
        ease_to_target(world, spec, pace, target->missing - now.missing, now, state);
        reached = is_reached(now);
    }
    dem::follow(state.energy, world, state.balance, state.time_step, damping);
    const PathRow row = measure_row(world, spec, state);
    const double due = rows_due(spec, state, row);
    const bool is_fit = is_fit_for_row(spec, row, due);
    const bool is_last = state.leg + 1 == count_legs(spec);
    const bool fails = spec.cycles ? has_liquefied(spec, state, row) : progress(spec, row) >= spec.strain && is_fit;
    const bool over = fails || (reached && is_last);
    if (over || reached || (due >= 1 && is_fit)) {
        state.rows.push_back(row);
    }
    if (!over) {
        if (reached) {
            turn(spec, row, state);
        }
        return false;
    }
    const bool is_cut_short = target && !(reached && is_last);
    if (is_cut_short && (!spec.cycles || (state.leg == 0 && spec.path == Path::Drained))) {
        report_out_of_reach(spec, state, row);
    }
    state.balance.steps = state.balance.balanced_steps = 0;
    give_back(world, state); // a balance is proved with the grains' own inertia
    if (spec.stops_at_stress()) {
        dem::take_time_step(state, choose_time_step(world, spec, damping), state.balance.equilibrium.contacts);
        state.phase = PathState::Phase::Settle;
    } else {
        end_path(world, spec, state);
    }
    return state.phase == PathState::Phase::Done;
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
