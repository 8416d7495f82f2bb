#include "suffuse/packing/compact.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::packing {
namespace {

// Share of the pressure below which the strain rate may be this share of the largest [reference, section 4: 250, 50, 20
// 1/s].
constexpr double loose_load = 0.02, half_load = 0.5;
constexpr double half_load_rate = 0.2, full_load_rate = 0.08;
constexpr std::int64_t time_step_interval = 1000; // steps between two looks at the stable time step
constexpr std::int64_t most_steps = 3'000'000;
constexpr double least_void_ratio = 0.05; // spheres overlap beyond any meaning before this

double rate_cap(const CompactSpec& spec, double pressure) {
    if (pressure < loose_load * spec.pressure) {
        return spec.max_rate;
    }
    return (pressure < half_load * spec.pressure ? half_load_rate : full_load_rate) * spec.max_rate;
}

/// Removes what the preparation lent: friction goes to its final value, bonds are cut.
void take_final_parameters(dem::World& world, const grains::Material& final_material) {
    world.material = final_material;
    if (final_material.adhesion_normal <= 0 && final_material.adhesion_shear <= 0) {
        std::fill(world.contacts.bonded.begin(), world.contacts.bonded.end(), std::uint8_t{0});
    }
}

[[noreturn]] void report_out_of_reach(const dem::World& world, const CompactSpec& spec, const CompactState& state) {
    throw StateError(fmt::format(
        "the pressure {:.4g} kPa is out of reach: after {} steps the sample carries {:.4g} kPa at the void ratio "
        "{:.3f}, "
        "unbalanced force {:.1e}; lower the pressure, raise contact.modulus, or give [balance] more room",
        spec.pressure / 1e3, state.steps, dem::mean_stress(state.balance.stress) / 1e3, dem::void_ratio(world),
        state.balance.equilibrium.unbalanced_force
    ));
}

} // namespace

CompactState begin_compaction(dem::World& world, const CompactSpec& spec, double damping) {
    CompactState state;
    state.material = world.material;
    state.damping = damping;
    const Prepare& prepare = spec.prepare;
    world.material.friction = prepare.friction.value_or(world.material.friction);
    world.material.adhesion_normal = prepare.adhesion_normal.value_or(world.material.adhesion_normal);
    world.material.adhesion_shear = prepare.adhesion_shear.value_or(world.material.adhesion_shear);
    return state;
}

bool compact_burst(
    dem::World& world, dem::StepCaches& caches, const CompactSpec& spec, const dem::BalanceSpec& balance,
    CompactState& state
) {
    if (state.steps % time_step_interval == 0) {
        state.time_step = spec.time_step > 0 ? spec.time_step : dem::stable_time_step(world);
    }
    dem::StepPlan plan;
    plan.dt = state.time_step;
    plan.damping = state.damping;
    plan.loading = dem::isotropic_stress(spec.pressure);
    plan.loading.servo.max_rate = rate_cap(spec, dem::mean_stress(state.balance.stress));
    const bool settled = dem::settle_burst(world, caches, plan, balance, state.balance);
    state.steps += dem::burst_steps;
    if (state.steps > most_steps || dem::void_ratio(world) < least_void_ratio) {
        report_out_of_reach(world, spec, state);
    }
    if (!settled) {
        return false;
    }
    state.balance.balanced_steps = 0;
    if (state.phase == CompactState::Phase::Compact) {
        state.void_ratio_compacted = dem::void_ratio(world);
        take_final_parameters(world, state.material);
        state.phase = CompactState::Phase::Settle;
        return false;
    }
    state.phase = CompactState::Phase::Done;
    return true;
}

} // namespace suffuse::packing
