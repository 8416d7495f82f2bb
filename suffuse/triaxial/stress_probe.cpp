#include "suffuse/triaxial/stress_probe.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/cell/strain.hpp"
#include "suffuse/dem/carried_stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/lent_inertia.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/triaxial/probed_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace suffuse::triaxial {
namespace {

constexpr double stress_share = 0.01; // of an increment: how closely it is met

Vec3 axial_stress(const Mat3& stress) {
    return {stress(0, 0), stress(1, 1), stress(2, 2)};
}

/// Of unit norm, in the plane where the two lateral stresses are equal.
Vec3 direction_of(double angle, int axis) {
    const double lateral = std::cos(angle) / std::numbers::sqrt2;
    Vec3 direction{lateral, lateral, lateral};
    direction[axis] = std::sin(angle);
    return direction;
}

cell::Loading held(const Vec3& stress) {
    cell::Loading loading;
    for (int a = 0; a < 3; ++a) {
        loading.axis[static_cast<std::size_t>(a)] = {cell::Control::Stress, stress[a]};
    }
    return loading;
}

dem::BalanceSpec goal_of(const StressProbeSpec& spec) {
    dem::BalanceSpec goal;
    goal.unbalanced_force = spec.unbalanced_force;
    goal.stress_error = stress_share * spec.increment;
    goal.patience = dem::burst_steps;
    return goal;
}

/// The increment grows over the ramp, and is then held until the sample rests.
StressProbe
load(const ProbedState& state, const StressProbeSpec& spec, const Vec3& increment, double damping, const Pulse& pulse) {
    LoadedSample sample{state.world, {}, {}, false};
    StressProbe probe;
    const dem::BalanceSpec goal = goal_of(spec);
    while (probe.answer == Answer::Rests && !(sample.rests && probe.steps >= spec.ramp)) {
        probe.steps += dem::burst_steps;
        const double share = std::min(1.0, static_cast<double>(probe.steps) / static_cast<double>(spec.ramp));
        burst(sample, held(state.stress + share * increment), state.time_step, damping, goal);
        probe.strain = cell::axial_strains(state.world.cell.h, sample.world.cell.h);
        if (norm(probe.strain) > spec.max_strain) {
            probe.answer = Answer::Fails;
        } else if (!sample.rests && probe.steps >= spec.ramp + spec.max_steps) {
            probe.answer = Answer::Creeps;
        }
        beat(pulse, "probe", probe.steps);
    }
    probe.stress = axial_stress(sample.balance.stress) - state.stress;
    return probe;
}

} // namespace

ProbedState rest_for_probes(const dem::World& world, const StressProbeSpec& spec, double damping, const Pulse& pulse) {
    const Mat3 carried = dem::mean_stress_tensor(world);
    dem::require_pressure(world, carried, "stress probes need a sample");
    const Vec3 stress = axial_stress(carried);
    const dem::BalanceSpec goal = goal_of(spec);
    LoadedSample sample{world, {}, {}, false};
    const double median = grains::median_diameter(world.grains);
    dem::lend_inertia(sample.world, median, {}, {true, true}); // where grains rest does not depend on it
    ProbedState state;
    state.time_step = spec.time_step > 0 ? spec.time_step : dem::stable_time_step(sample.world, {damping});
    while (!sample.rests) {
        burst(sample, held(stress), state.time_step, damping, goal);
        state.steps += dem::burst_steps;
        const double strain = norm(cell::axial_strains(world.cell.h, sample.world.cell.h));
        if (strain > spec.max_strain || (!sample.rests && state.steps >= spec.max_steps)) {
            throw StateError(fmt::format(
                "the sample is not at rest under the stress that it carries: after {} steps it has strained by {:.2e} "
                "and its unbalanced force is {:.1e} (required {:.1e}); probe a state further from failure, or raise "
                "unbalanced_force",
                state.steps, strain, sample.balance.equilibrium.unbalanced_force, spec.unbalanced_force
            ));
        }
        beat(pulse, "rest", state.steps);
    }
    state.world = std::move(sample.world);
    state.stress = axial_stress(sample.balance.stress);
    state.drift = norm(load(state, spec, {}, damping, pulse).strain);
    return state;
}

StressProbe
probe_direction(const ProbedState& state, const StressProbeSpec& spec, int number, double damping, const Pulse& pulse) {
    const double angle = 2 * pi * number / spec.directions;
    const double size = spec.increment * (state.stress.x + state.stress.y + state.stress.z) / 3;
    StressProbe probe = load(state, spec, size * direction_of(angle, spec.axis), damping, pulse);
    probe.angle = angle;
    probe.second_order_work = dot(probe.stress, probe.strain);
    const double sizes = norm(probe.stress) * norm(probe.strain);
    probe.normalized = sizes > 0 ? probe.second_order_work / sizes : 0;
    return probe;
}

} // namespace suffuse::triaxial
