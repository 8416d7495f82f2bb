#include "suffuse/dem/settle.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/dem/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::dem {

namespace {

/// Of its radius, which a stress that counts as none makes a grain overlap by [-].
constexpr double unloaded = 1e-8;

/// What the axes under stress control are to bear, and what they do [Pa]. Released shear stresses count, together, as
/// one that is to be none.
struct Borne {
    int axes = 0;
    double wanted = 0, found = 0, error = 0; ///< each the largest of them, in size
};

Borne borne_by(const cell::Loading& loading, const Mat3& stress) {
    Borne borne;
    for (int a = 0; a < 3 && !loading.velocity_gradient; ++a) {
        if (loading.axis[static_cast<std::size_t>(a)].control == cell::Control::StrainRate) {
            continue;
        }
        const double wanted = cell::wanted_stress(loading, a, {stress(0, 0), stress(1, 1), stress(2, 2)});
        ++borne.axes;
        borne.wanted = std::max(borne.wanted, std::abs(wanted));
        borne.found = std::max(borne.found, std::abs(stress(a, a)));
        borne.error = std::max(borne.error, std::abs(wanted - stress(a, a)));
    }
    if (cell::releases_shear(loading)) {
        const double shear = norm(cell::shear_stresses(stress));
        borne.found = std::max(borne.found, shear);
        borne.error = std::max(borne.error, shear);
    }
    return borne;
}

/// A sample that is to bear nothing on all its axes rests when it does: what is left of its contacts is no measure of a
/// balance, and there may be none.
bool is_balanced(
    const cell::Loading& loading, const BalanceSpec& spec, const BalanceState& state, const grains::Material& material
) {
    const Borne borne = borne_by(loading, state.stress);
    const bool unloads = borne.axes > 0 && borne.wanted == 0;
    if (unloads && contact::spring_of(material).overlap_under(material, borne.found) > unloaded) {
        return false;
    }
    if (unloads && borne.axes == 3) {
        return true;
    }
    return state.equilibrium.mean_contact_force > 0 && state.equilibrium.unbalanced_force <= spec.unbalanced_force &&
           stress_error(loading, state.stress) <= spec.stress_error;
}

} // namespace

double stress_error(const cell::Loading& loading, const Mat3& stress) {
    const Borne borne = borne_by(loading, stress);
    return borne.wanted > 0 ? borne.error / borne.wanted : 0;
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
    state.equilibrium = measure_equilibrium(world, plan.load);
    const bool balanced = is_balanced(plan.loading, spec, state, world.material);
    state.balanced_steps = balanced ? state.balanced_steps + burst_steps : 0;
    return state.balanced_steps >= spec.patience;
}

bool carries_nothing(
    const cell::Loading& loading, const BalanceSpec& spec, const BalanceState& state, double stress_before
) {
    const auto stands = [](const cell::AxisControl& axis) {
        return axis.control == cell::Control::StrainRate && axis.value == 0;
    };
    return !loading.velocity_gradient && std::ranges::all_of(loading.axis, stands) && state.steps >= spec.patience &&
           mean_stress(state.stress) <= lost_stress * std::max(stress_before, 0.0);
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

void report_not_balanced(
    const cell::Loading& loading, const BalanceSpec& spec, const BalanceState& state, std::string_view limit
) {
    const double error = stress_error(loading, state.stress);
    const char* const advice =
        borne_by(loading, state.stress).axes == 0
            ? "no stress is held: specify a less strict balance, or a stress that keeps the grains together"
        : error <= spec.stress_error
            ? "the stress is held, but grains still rearrange: specify a less strict balance, or start from a denser "
              "sample"
            : "this sample may be unable to carry the stress: lower it, or specify a less strict balance";
    throw StateError(fmt::format(
        "not balanced after {} steps: unbalanced force {:.2e} (required {:.2e}), stress error {:.2e} (required "
        "{:.2e}), mean stress {:.4g} kPa; {}{}",
        state.steps, state.equilibrium.unbalanced_force, spec.unbalanced_force, error, spec.stress_error,
        mean_stress(state.stress) / 1e3, limit.empty() ? "" : fmt::format("raise {}, or ", limit), advice
    ));
}

} // namespace suffuse::dem
