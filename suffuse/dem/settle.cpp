#include "suffuse/dem/settle.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::dem {

double stress_error(const cell::Loading& loading, const Mat3& stress) {
    if (loading.velocity_gradient) {
        return 0;
    }
    double largest = 0, error = 0;
    for (int a = 0; a < 3; ++a) {
        const cell::AxisControl& axis = loading.axis[static_cast<std::size_t>(a)];
        if (axis.control == cell::Control::StrainRate) {
            continue;
        }
        const double wanted = cell::wanted_stress(loading, a, {stress(0, 0), stress(1, 1), stress(2, 2)});
        largest = std::max(largest, std::abs(wanted));
        error = std::max(error, std::abs(wanted - stress(a, a)));
    }
    return largest > 0 ? error / largest : 0;
}

cell::Loading isotropic_stress(double pressure) {
    cell::Loading loading;
    loading.axis.fill({cell::Control::Stress, pressure});
    return loading;
}

cell::Loading constant_volume() {
    return {};
}

bool settle_burst(
    World& world, StepCaches& caches, const StepPlan& plan, const BalanceSpec& spec, BalanceState& state
) {
    state.stress = advance(world, caches, plan, burst_steps).stress;
    state.steps += burst_steps;
    state.equilibrium = measure_equilibrium(world);
    const bool balanced = state.equilibrium.contacts > 0 &&
                          state.equilibrium.unbalanced_force <= spec.unbalanced_force &&
                          stress_error(plan.loading, state.stress) <= spec.stress_error;
    state.balanced_steps = balanced ? state.balanced_steps + burst_steps : 0;
    return state.balanced_steps >= spec.patience;
}

BalanceState
settle(World& world, StepCaches& caches, const StepPlan& plan, const BalanceSpec& spec, std::int64_t max_steps) {
    BalanceState state;
    while (!settle_burst(world, caches, plan, spec, state)) {
        if (state.steps < max_steps) {
            continue;
        }
        report_not_balanced(plan.loading, spec, state);
    }
    return state;
}

void report_not_balanced(const cell::Loading& loading, const BalanceSpec& spec, const BalanceState& state) {
    throw StateError(fmt::format(
        "not balanced after {} steps: unbalanced force {:.2e} (wanted {:.2e}), stress error {:.2e} (wanted {:.2e}), "
        "mean stress {:.4g} kPa; the stress may be out of reach of this sample: lower it, or give [balance] more room",
        state.steps, state.equilibrium.unbalanced_force, spec.unbalanced_force, stress_error(loading, state.stress),
        spec.stress_error, mean_stress(state.stress) / 1e3
    ));
}

} // namespace suffuse::dem
