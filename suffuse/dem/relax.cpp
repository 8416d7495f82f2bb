#include "suffuse/dem/relax.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::dem {
namespace {

// The drag that settles a packing keeps a chain of loose grains from finding its place: it creeps there. Where the
// unbalance has not halved for as long as a packing needs, the drag lets go of the grains for a while, and holds again.
constexpr std::int64_t held_bursts = 60, free_bursts = 40, cycle = held_bursts + free_bursts;
constexpr std::int64_t most_cycles = 6; // without halving: what is left is the floor

/// Rattlers have no unbalanced force; a cloud of nothing else is not in equilibrium.
void check_something_is_held(const World& world, const Equilibrium& equilibrium) {
    const auto grains = static_cast<std::int64_t>(world.grains.size());
    if (equilibrium.rattlers == grains) {
        throw StateError(fmt::format(
            "no equilibrium to relax: none of the {} grains has two contacts or more, which hold it; compact or settle "
            "the sample under a pressure first",
            grains
        ));
    }
}

/// A world without contacts may have none, or has yet to find them; and before the first step its forces are guesses.
double first_unbalance(const World& world) {
    const Equilibrium start = measure_equilibrium(world);
    return start.contacts > 0 && !awaits_first_step(world) ? start.unbalanced_force
                                                           : std::numeric_limits<double>::max();
}

} // namespace

double slowest_mode_drag(std::size_t grains, double dt) {
    // Its period grows with the width of the sample in grains; measured on 10,000 grains: 2e5 1/s at dt = 4.1e-8 s
    // relaxes to 1e-9 in 2,000 steps.
    constexpr double share_at_10k = 0.0082, grains_at_10k = 1e4;
    return share_at_10k / dt * std::cbrt(grains_at_10k / static_cast<double>(std::max<std::size_t>(grains, 1)));
}

void relax(
    World& world, StepCaches& caches, double dt, double damping, double wanted, std::int64_t most_steps,
    Relaxation& so_far, const Pulse& pulse
) {
    StepPlan plan;
    plan.dt = dt;
    plan.damping = damping;
    plan.loading = constant_volume();
    const double drag = slowest_mode_drag(world.grains.size(), dt);
    if (so_far.steps == 0) {
        so_far.best = first_unbalance(world);
    }
    while (so_far.steps < most_steps && so_far.since_best < most_cycles * cycle) {
        const bool held = so_far.since_best % cycle < held_bursts;
        plan.drag = held ? drag : 0;
        advance(world, caches, plan, burst_steps);
        so_far.steps += burst_steps;
        const Equilibrium equilibrium = measure_equilibrium(world);
        if (so_far.steps == burst_steps) {
            check_something_is_held(world, equilibrium);
        }
        so_far.unbalanced_force = equilibrium.unbalanced_force;
        if (held && so_far.unbalanced_force <= wanted) {
            return;
        }
        ++so_far.since_best;
        if (held && so_far.unbalanced_force < 0.5 * so_far.best) {
            so_far.best = so_far.unbalanced_force;
            so_far.since_best = 0;
        }
        beat(pulse, "relax", so_far.steps);
    }
    so_far.reached_floor = true;
}

} // namespace suffuse::dem
