#include "suffuse/packing/pace.hpp"

#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::packing {
namespace {

// Share of the pressure below which the strain rate may be this share of the largest [reference, section 4: 250, 50, 20
// 1/s].
constexpr double loose_load = 0.02, half_load = 0.5;
constexpr double half_load_rate = 0.2, full_load_rate = 0.08;

// Faithful and wide: above this share of the pressure a drag of this share of what damps the slowest mode best; more of
// it would leave grains where they touch that `slow` lets go (0.1: rattlers 27 % instead of 29 %).
constexpr double loaded = 0.9, loaded_drag = 0.03;

// Swift: the strain rate falls as the unbalanced force exceeds this; largest strain rate as an inertial number, which
// stays below what counts as quasi-static with the grains' own mass; response of the servo in steps.
constexpr double restless_above = 0.05, first_touch = 0.01;
constexpr double largest_inertial_number = 5e-3;
constexpr double swift_response = 30;

// Wide: up to this size of the median grain over the smallest one, grains are lent mass gently: more of it leaves
// samples looser (size ratio 6.5: by 0.017 in void ratio), and beyond it takes too many steps.
constexpr double gentle_spread = 15;

constexpr double p_wave_share = 0.3; // of the P-wave time of the smallest grain [reference, section 1.6]

double rate_cap(const dem::World& world, const CompactSpec& spec, const CompactState& state, double pressure) {
    const double most = largest_rate(spec, world.material.density, state.median_diameter);
    if (pressure < loose_load * spec.pressure) {
        return most;
    }
    return (pressure < half_load * spec.pressure ? half_load_rate : full_load_rate) * most;
}

/// Of the mean diameter, at the pressure [1/s].
double swift_rate(const dem::World& world, double pressure) {
    double diameter = 0;
    for (const double r : world.grains.radius) {
        diameter += 2 * r;
    }
    diameter /= static_cast<double>(world.grains.size());
    return dem::rate_of_inertial_number(largest_inertial_number, diameter, world.material.density, pressure);
}

/// The reference's servo; a mass of twice that of the grains over the edge of the cell is stable [kg/m].
cell::ServoSpec inertial_servo(const dem::World& world) {
    double mass = 0;
    for (const double m : world.grains.mass) {
        mass += m;
    }
    cell::ServoSpec servo;
    servo.kind = cell::ServoKind::Inertial;
    servo.mass = 2 * mass / std::cbrt(cell::volume(world.cell));
    return servo;
}

Pace swift_pace(
    const dem::World& world, const CompactSpec& spec, const dem::BalanceSpec& balance, const CompactState& state,
    dem::StepPlan plan
) {
    const bool relaxing = state.phase == CompactState::Phase::Relax;
    const bool carries = dem::mean_stress(state.balance.stress) > first_touch * spec.pressure;
    const double unbalance = state.balance.equilibrium.unbalanced_force, calm = swift_calm(balance);
    const bool restless = carries && unbalance > calm;
    plan.drag = dem::slowest_mode_drag(world.grains.size(), plan.dt);
    if (relaxing) {
        plan.loading = dem::constant_volume();
    }
    plan.loading.servo.max_rate = swift_rate(world, spec.pressure) * (restless ? calm / unbalance : 1);
    plan.loading.servo.response = swift_response;
    return {plan, relaxing || restless};
}

} // namespace

Pace choose_pace(
    const dem::World& world, const CompactSpec& spec, const dem::BalanceSpec& balance, const CompactState& state
) {
    dem::StepPlan plan;
    plan.mode = state.mode;
    plan.dt = state.time_step;
    plan.damping = state.damping;
    plan.loading = dem::isotropic_stress(spec.pressure);
    plan.loading.shear_released = spec.shear_released;
    const bool proving = state.phase == CompactState::Phase::Prove;
    if (spec.protocol == Protocol::Swift && !proving) {
        return swift_pace(world, spec, balance, state, plan);
    }
    const double pressure = dem::mean_stress(state.balance.stress);
    if (spec.protocol == Protocol::Slow) {
        plan.loading.servo = inertial_servo(world);
    }
    plan.loading.servo.max_rate = rate_cap(world, spec, state, pressure);
    const bool drags = spec.protocol == Protocol::Faithful || spec.protocol == Protocol::Wide;
    if (drags && !proving && is_loaded(spec, state)) {
        plan.drag = loaded_drag * dem::slowest_mode_drag(world.grains.size(), plan.dt);
    }
    return {plan, false};
}

double swift_calm(const dem::BalanceSpec& balance) {
    return std::max(restless_above, balance.unbalanced_force);
}

bool is_loaded(const CompactSpec& spec, const CompactState& state) {
    return dem::mean_stress(state.balance.stress) > loaded * spec.pressure;
}

double largest_rate(const CompactSpec& spec, double density, double median_diameter) {
    return spec.max_rate.value_or(
        dem::rate_of_inertial_number(cloud_inertial_number, median_diameter, density, spec.pressure)
    );
}

double choose_time_step(const dem::World& world, const CompactSpec& spec, double damping) {
    if (spec.time_step > 0) {
        return spec.time_step;
    }
    const double stable = dem::stable_time_step(world, {damping, spec.pressure});
    if (spec.protocol != Protocol::Slow) {
        return stable;
    }
    return std::min(stable, slow_time_step(*std::ranges::min_element(world.grains.radius), world.material));
}

double slow_time_step(double smallest, const grains::Material& material) {
    return p_wave_share * smallest * std::sqrt(material.density / material.modulus);
}

bool adheres_at_first(const CompactSpec& spec) {
    return spec.prepare.adhesion_normal.value_or(0) > 0 || spec.prepare.adhesion_shear.value_or(0) > 0;
}

dem::Lent lent_to_wide(double spread) {
    return {.mass = true, .gently = spread <= gentle_spread, .fines_rotation = true};
}

dem::Lent choose_lent(const dem::World& world, const CompactSpec& spec, const CompactState& state) {
    using Phase = CompactState::Phase;
    if (spec.protocol == Protocol::Slow || spec.time_step > 0 || state.phase == Phase::Prove) {
        return {};
    }
    if (spec.protocol == Protocol::Swift) {
        return {true, true};
    }
    // Bonded grains go where they are pushed, and near balance nothing moves much; a skeleton that collapses in
    // between, its bonds cut, would end looser with heavier grains.
    const bool loaded = is_loaded(spec, state), collapsing = state.phase == Phase::Settle && !loaded;
    const bool bonded = state.phase == Phase::Compact && adheres(world.material);
    if (spec.protocol != Protocol::Wide) {
        return {!collapsing, bonded || loaded};
    }
    // Where there is nothing to collapse, nothing changes on the way. A skeleton that collapses keeps its masses, but
    // its fines need not roll so quickly that they alone set the time step.
    const double smallest = 2 * *std::ranges::min_element(world.grains.radius);
    return collapsing && adheres_at_first(spec) ? dem::Lent{.fines_rotation = true}
           : adheres_at_first(spec)             ? dem::Lent{true, true}
                                                : lent_to_wide(state.median_diameter / smallest);
}

} // namespace suffuse::packing
