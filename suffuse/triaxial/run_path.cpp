#include "suffuse/triaxial/run_path.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/gradation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace suffuse::triaxial {
namespace {

constexpr std::int64_t time_step_interval = 2000;
constexpr double creep_room = 1.1;       // axial strain until at rest, at most, over the largest during the test [-]
constexpr double smoothed_span = 1e-3;   // axial strain over which rows are averaged before their work is looked at [-]
constexpr double least_smoothed = 2;     // rows
constexpr double liquefied_share = 0.05; // of the mean stress at the start [-]
constexpr double fastest_lateral = 2;    // rate of an axis whose stress is held, at most, over the axial rate [-]

double lateral_mean(const Mat3& stress, int axis) {
    return 0.5 * (trace(stress) - stress(axis, axis));
}

double deviator(const Mat3& stress, int axis) {
    return stress(axis, axis) - lateral_mean(stress, axis);
}

cell::Loading loading_of(const TriaxialSpec& spec, const PathState& state) {
    cell::Loading loading;
    // A sample widens at half of its axial rate and its dilatancy together: the servo must be able to follow, but no
    // axis may be faster than quasi-static.
    loading.servo.max_rate = fastest_lateral * state.strain_rate;
    for (int a = 0; a < 3; ++a) {
        cell::AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        if (a == spec.axis) {
            axis = {cell::Control::StrainRate, state.strain_rate};
        } else if (spec.path == Path::Undrained) {
            axis = {cell::Control::StrainRate, -0.5 * state.strain_rate};
        } else if (spec.path == Path::ConstantMean) {
            const double missing = trace(state.start_stress) - state.balance.stress(spec.axis, spec.axis);
            axis = {cell::Control::Stress, 0.5 * missing};
        } else {
            axis = {cell::Control::Stress, state.start_stress(a, a)};
        }
    }
    return loading;
}

/// The deviator stress asked for, at the lateral or mean stress that the path holds [Pa].
double wanted_deviator(const TriaxialSpec& spec, const PathState& state) {
    if (spec.deviator_stress) {
        return *spec.deviator_stress;
    }
    const double eta = *spec.stress_ratio; // q = eta p, with p = lateral + q/3
    return spec.path == Path::ConstantMean ? eta * dem::mean_stress(state.start_stress)
                                           : eta * lateral_mean(state.start_stress, spec.axis) / (1 - eta / 3);
}

/// The stresses to come to rest at: the deviator stress asked for, beside what is held during the test.
cell::Loading final_loading(const TriaxialSpec& spec, const PathState& state) {
    if (spec.path == Path::Undrained) {
        return dem::constant_volume();
    }
    cell::Loading loading = loading_of(spec, state);
    const double q = wanted_deviator(spec, state), p = dem::mean_stress(state.start_stress);
    double axial = lateral_mean(state.start_stress, spec.axis) + q;
    if (spec.path == Path::ConstantMean) {
        loading.axis.fill({cell::Control::Stress, p - q / 3});
        axial = p + 2 * q / 3;
    }
    loading.axis[static_cast<std::size_t>(spec.axis)] = {cell::Control::Stress, axial};
    return loading;
}

bool has_stress_target(const TriaxialSpec& spec) {
    return spec.deviator_stress || spec.stress_ratio;
}

bool target_reached(const TriaxialSpec& spec, const PathRow& row) {
    return (spec.deviator_stress && row.deviator_stress >= *spec.deviator_stress) ||
           (spec.stress_ratio && row.deviator_stress >= *spec.stress_ratio * row.mean_stress);
}

double axial_strain(const Mat3& stretch, int axis) {
    return -std::log(stretch(axis, axis));
}

PathRow measure_row(const dem::World& world, const TriaxialSpec& spec, const PathState& state) {
    const Mat3 stretch = world.cell.h * inverse(state.start_h);
    const Mat3& stress = state.balance.stress;
    PathRow row;
    row.axial_strain = axial_strain(stretch, spec.axis);
    row.volumetric_strain = -std::log(determinant(stretch));
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
    if (spec.path == Path::Undrained) { // the total lateral stress is held: water takes what grains no longer carry
        row.excess_pore_pressure = lateral_mean(state.start_stress, spec.axis) - lateral_mean(stress, spec.axis);
    }
    return row;
}

[[noreturn]] void report_out_of_reach(const PathRow& row) {
    throw StateError(fmt::format(
        "the stress asked of the triaxial test is out of reach: at {:.3g} % axial strain the deviator stress is "
        "{:.4g} kPa (q/p = {:.3f}); ask for less than the peak of this sample",
        100 * row.axial_strain, row.deviator_stress / 1e3, row.deviator_stress / row.mean_stress
    ));
}

/// A sample that cannot carry the stress goes on straining, or never comes to rest.
void check_settling(
    const dem::World& world, const TriaxialSpec& spec, const dem::BalanceSpec& balance, const PathState& state
) {
    const double strain = axial_strain(world.cell.h * inverse(state.start_h), spec.axis);
    if (strain > creep_room * std::max(spec.strain, state.rows.back().axial_strain)) {
        report_out_of_reach(measure_row(world, spec, state));
    }
    if (state.balance.steps >= dem::SettleSpec{}.max_steps) {
        dem::report_not_balanced(final_loading(spec, state), balance, state.balance);
    }
}

} // namespace

PathState begin_path(dem::World& world, const TriaxialSpec& spec, const Mat3& stress, double time_step) {
    if (!(spec.strain > 0) || !(spec.inertial_number > 0) || spec.rows < 1) {
        throw CaseError(fmt::format(
            "triaxial: found strain {}, inertial_number {}, rows {}; expected all of them above 0", spec.strain,
            spec.inertial_number, spec.rows
        ));
    }
    const double pressure = dem::mean_stress(stress);
    if (!(pressure > 0)) {
        throw StateError(fmt::format(
            "a triaxial test needs a sample that carries a stress, and this one's mean stress is {:.4g} kPa: compact "
            "or "
            "settle it under a pressure first",
            pressure / 1e3
        ));
    }
    PathState state;
    state.start_h = world.cell.h;
    state.start_stress = stress;
    state.balance.stress = stress;
    state.median_diameter = stats::size_at(stats::measure_gradation(world.grains), 0.5);
    state.strain_rate =
        dem::rate_of_inertial_number(spec.inertial_number, state.median_diameter, world.material.density, pressure);
    state.time_step = time_step;
    state.balance.equilibrium = dem::measure_equilibrium(world);
    state.rows.push_back(measure_row(world, spec, state));
    return state;
}

bool path_burst(
    dem::World& world, dem::StepCaches& caches, const TriaxialSpec& spec, const dem::BalanceSpec& balance,
    double damping, dem::Mode mode, PathState& state
) {
    if (spec.time_step <= 0 && state.steps % time_step_interval == 0) {
        state.time_step = dem::stable_time_step(world);
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
            state.phase = PathState::Phase::Done;
        } else {
            check_settling(world, spec, balance, state);
        }
        return settled;
    }
    const PathRow row = measure_row(world, spec, state);
    const bool reached = target_reached(spec, row);
    const bool over = reached || row.axial_strain >= spec.strain;
    if (over || row.axial_strain - state.rows.back().axial_strain >= spec.strain / spec.rows) {
        state.rows.push_back(row);
    }
    if (!over) {
        return false;
    }
    if (has_stress_target(spec) && !reached) {
        report_out_of_reach(row);
    }
    state.balance.steps = state.balance.balanced_steps = 0;
    state.phase = reached ? PathState::Phase::Settle : PathState::Phase::Done;
    return !reached;
}

double second_order_work(const PathRow& before, const PathRow& after) {
    const double volumetric = after.volumetric_strain - before.volumetric_strain;
    const double shear = after.axial_strain - before.axial_strain - volumetric / 3;
    return (after.mean_stress - before.mean_stress) * volumetric +
           (after.deviator_stress - before.deviator_stress) * shear;
}

namespace {

/// Strains and stresses only.
PathRow mean_row(std::span<const PathRow> rows) {
    const double share = 1 / static_cast<double>(rows.size());
    PathRow mean;
    for (const PathRow& row : rows) {
        mean.axial_strain += share * row.axial_strain;
        mean.volumetric_strain += share * row.volumetric_strain;
        mean.mean_stress += share * row.mean_stress;
        mean.deviator_stress += share * row.deviator_stress;
    }
    return mean;
}

/// From the mean of some rows to that of as many after them, so that the noise of single rows is no instability.
std::optional<Instability> find_instability(std::span<const PathRow> rows) {
    const double strain = rows.back().axial_strain - rows.front().axial_strain;
    const double wanted = std::ceil(smoothed_span / strain * static_cast<double>(rows.size() - 1));
    if (!(strain > 0) || 2 * wanted > static_cast<double>(rows.size())) {
        return {};
    }
    const auto span = static_cast<std::size_t>(std::max(least_smoothed, wanted));
    for (std::size_t k = span; k + span <= rows.size(); ++k) {
        if (second_order_work(mean_row(rows.subspan(k - span, span)), mean_row(rows.subspan(k, span))) <= 0) {
            const PathRow here = mean_row(rows.subspan(k - span, 2 * span));
            return Instability{here.deviator_stress, here.mean_stress, here.axial_strain};
        }
    }
    return {};
}

} // namespace

Response summarize(const std::vector<PathRow>& rows, Path path) {
    Response response;
    if (rows.empty()) {
        return response;
    }
    const double start = rows.front().deviator_stress;
    for (const PathRow& row : rows) {
        if (row.deviator_stress > response.peak_deviator) {
            response.peak_deviator = row.deviator_stress;
            response.peak_strain = row.axial_strain;
            response.peak_ratio = row.deviator_stress / row.mean_stress;
            const double lateral = row.mean_stress - row.deviator_stress / 3;
            response.friction_angle = std::asin(row.deviator_stress / (row.deviator_stress + 2 * lateral));
        }
        response.largest_contraction = std::max(response.largest_contraction, row.volumetric_strain);
    }
    const double half = start + 0.5 * (response.peak_deviator - start);
    for (std::size_t k = 1; k < rows.size() && response.stiffness == 0; ++k) {
        const PathRow &a = rows[k - 1], &b = rows[k];
        if (b.deviator_stress < half) {
            continue;
        }
        const double share = (half - a.deviator_stress) / (b.deviator_stress - a.deviator_stress);
        const double strain = a.axial_strain + share * (b.axial_strain - a.axial_strain);
        if (strain > 0) {
            response.stiffness = (half - start) / strain;
        }
    }
    // Slope over one percent of strain, so that the noise of single rows does not count as dilatancy.
    constexpr double slope_span = 0.01;
    for (std::size_t k = 0, first = 0; k < rows.size(); ++k) {
        while (rows[k].axial_strain - rows[first].axial_strain > slope_span) {
            ++first;
        }
        const double run = rows[k].axial_strain - rows[first].axial_strain;
        if (run < 0.8 * slope_span) {
            continue;
        }
        const double slope = -(rows[k].volumetric_strain - rows[first].volumetric_strain) / run;
        response.dilatancy = std::max(response.dilatancy, slope);
    }
    response.final_deviator = rows.back().deviator_stress;
    response.final_volumetric_strain = rows.back().volumetric_strain;
    response.instability = find_instability(rows);
    if (path == Path::Undrained) {
        response.liquefied = std::any_of(rows.begin(), rows.end(), [&](const PathRow& row) {
            return row.mean_stress < liquefied_share * rows.front().mean_stress;
        });
        response.excess_pore_pressure = rows.back().excess_pore_pressure;
    }
    return response;
}

} // namespace suffuse::triaxial
