#include "suffuse/dem/relax.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/settle.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::dem {
namespace {

constexpr std::int64_t floor_bursts = 60; // without halving the unbalance: it has stopped falling

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
    plan.drag = slowest_mode_drag(world.grains.size(), dt);
    plan.loading = constant_volume();
    RelaxReport report;
    report.unbalanced_force = measure_equilibrium(world).unbalanced_force;
    double best = report.unbalanced_force;
    std::int64_t since_best = 0;
    while (report.steps < most_steps) {
        advance(world, caches, plan, burst_steps);
        report.steps += burst_steps;
        report.unbalanced_force = measure_equilibrium(world).unbalanced_force;
        if (report.unbalanced_force <= wanted) {
            return report;
        }
        since_best = report.unbalanced_force < 0.5 * best ? 0 : since_best + 1;
        best = std::min(best, report.unbalanced_force < 0.5 * best ? report.unbalanced_force : best);
        if (since_best > floor_bursts) {
            break;
        }
        beat(pulse, "relax", report.steps);
    }
    report.reached_floor = true;
    return report;
}

} // namespace suffuse::dem
