#include "suffuse/dem/relax.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/settle.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

// The drag that settles a packing keeps a chain of loose grains from finding its place: it creeps there. Where the
// unbalance has not halved for as long as a packing needs, the drag lets go of the grains for a while, and holds again.
constexpr std::int64_t held_bursts = 60, free_bursts = 40, cycle = held_bursts + free_bursts;
constexpr std::int64_t most_cycles = 6; // without halving: what is left is the floor

} // namespace

double slowest_mode_drag(std::size_t grains, double dt) {
    // Its period grows with the width of the sample in grains; measured on 10,000 grains: 2e5 1/s at dt = 4.1e-8 s
    // relaxes to 1e-9 in 2,000 steps.
    constexpr double share_at_10k = 0.0082, grains_at_10k = 1e4;
    return share_at_10k / dt * std::cbrt(grains_at_10k / static_cast<double>(std::max<std::size_t>(grains, 1)));
}

RelaxReport relax(
    World& world, StepCaches& caches, double dt, double damping, double wanted, std::int64_t most_steps,
    const Pulse& pulse
) {
    StepPlan plan;
    plan.dt = dt;
    plan.damping = damping;
    plan.loading = constant_volume();
    const double drag = slowest_mode_drag(world.grains.size(), dt);
    RelaxReport report;
    double best = measure_equilibrium(world).unbalanced_force;
    std::int64_t since_best = 0; // bursts
    while (report.steps < most_steps && since_best < most_cycles * cycle) {
        const bool held = since_best % cycle < held_bursts;
        plan.drag = held ? drag : 0;
        advance(world, caches, plan, burst_steps);
        report.steps += burst_steps;
        report.unbalanced_force = measure_equilibrium(world).unbalanced_force;
        if (held && report.unbalanced_force <= wanted) {
            return report;
        }
        ++since_best;
        if (held && report.unbalanced_force < 0.5 * best) {
            best = report.unbalanced_force;
            since_best = 0;
        }
        beat(pulse, "relax", report.steps);
    }
    report.reached_floor = true;
    return report;
}

} // namespace suffuse::dem
