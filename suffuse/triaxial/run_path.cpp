#include "suffuse/triaxial/run_path.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/gradation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::triaxial {
namespace {

constexpr std::int64_t time_step_interval = 2000;
constexpr double fastest_lateral = 2; // rate of an axis whose stress is held, at most, over the axial rate [-]

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

/// The stresses to come to rest at: those held during the test, and the axial one that was asked for.
cell::Loading final_loading(const TriaxialSpec& spec, const PathState& state) {
    cell::Loading loading = loading_of(spec, state);
    if (spec.path == Path::Undrained) {
        return dem::constant_volume();
    }
    const double lateral = lateral_mean(state.start_stress, spec.axis);
    double axial = state.balance.stress(spec.axis, spec.axis);
    if (spec.path == Path::Drained && spec.deviator_stress) {
        axial = lateral + *spec.deviator_stress;
    }
    if (spec.path == Path::Drained && spec.stress_ratio) { // q/p = eta with p = lateral + q/3
        axial = lateral + *spec.stress_ratio * lateral / (1 - *spec.stress_ratio / 3);
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

PathRow measure_row(const dem::World& world, const TriaxialSpec& spec, const PathState& state) {
    const Mat3 stretch = world.cell.h * inverse(state.start_h);
    const Mat3& stress = state.balance.stress;
    PathRow row;
    row.axial_strain = -std::log(stretch(spec.axis, spec.axis));
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
    row.inertial_number =
        rate * state.median_diameter * std::sqrt(world.material.density / std::max(row.mean_stress, 1e-300));
    return row;
}

} // namespace

PathState begin_path(dem::World& world, const TriaxialSpec& spec, const Mat3& stress, double time_step) {
    PathState state;
    state.start_h = world.cell.h;
    state.start_stress = stress;
    state.balance.stress = stress;
    state.median_diameter = stats::size_at(stats::measure_gradation(world.grains), 0.5);
    state.strain_rate =
        spec.inertial_number * std::sqrt(dem::mean_stress(stress) / world.material.density) / state.median_diameter;
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
        }
        return settled;
    }
    const PathRow row = measure_row(world, spec, state);
    const bool over = row.axial_strain >= spec.strain || target_reached(spec, row);
    if (over || row.axial_strain - state.rows.back().axial_strain >= spec.strain / spec.rows) {
        state.rows.push_back(row);
    }
    if (!over) {
        return false;
    }
    state.balance.balanced_steps = 0;
    state.phase = has_stress_target(spec) ? PathState::Phase::Settle : PathState::Phase::Done;
    return state.phase == PathState::Phase::Done;
}

Response summarize(const std::vector<PathRow>& rows) {
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
    return response;
}

} // namespace suffuse::triaxial
