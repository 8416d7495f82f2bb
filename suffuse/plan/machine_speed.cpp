#include "suffuse/plan/machine_speed.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/step.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace suffuse::plan {
namespace {

// Layers of a square lattice: of its four neighbors a grain touches some 3.4, as in a settled sand.
constexpr double mean_radius = 1e-4; // [m]
constexpr double radius_spread = 0.01, place_spread = 0.004, mean_overlap = 0.0044, layer_gap = 0.1;
constexpr std::size_t windows = 9;
constexpr std::int64_t warm_up = 30;      // steps: first pairs, pages, threads
constexpr double work_of_burst = 500'000; // grains x steps: the shares of a window that are timed as a whole

dem::World made_up_packing(int edge) {
    dem::World world;
    const double spacing = 2 * mean_radius * (1 - mean_overlap);
    const Vec3 period{spacing, spacing, (1 + layer_gap) * spacing};
    world.cell.h = diagonal(static_cast<double>(edge) * period);
    world.reference_h = world.cell.h;
    RandomStream random(0, "machine speed");
    const auto spread = [&] { return random.uniform(-1, 1); };
    for (int a = 0; a < edge; ++a) {
        for (int b = 0; b < edge; ++b) {
            for (int c = 0; c < edge; ++c) {
                const Vec3 place{a * period.x, b * period.y, c * period.z};
                const Vec3 jitter{spread(), spread(), spread()};
                const double radius = mean_radius * (1 + radius_spread * spread());
                add_grain(world.grains, place + place_spread * mean_radius * jitter, radius, world.material.density);
            }
        }
    }
    return world;
}

/// Steps per second of one packing, the upper quartile of several windows: a moment that others take counts for little.
double steps_per_second(dem::World world, double seconds, dem::Mode mode) {
    dem::sort_along_curve(world);
    dem::StepPlan plan;
    dem::StepCaches caches;
    plan.mode = mode;
    plan.dt = 0.2 * dem::stable_time_step(world); // no contacts yet: far below what the network will allow
    dem::advance(world, caches, plan, warm_up);
    const double grains = static_cast<double>(world.grains.size());
    const auto burst = std::clamp<std::int64_t>(std::llround(work_of_burst / grains), 5, dem::burst_steps);
    std::vector<double> rates(windows);
    for (double& rate : rates) {
        const Stopwatch watch;
        double spent = 0;
        std::int64_t steps = 0;
        while (spent < seconds / windows) {
            dem::advance(world, caches, plan, burst);
            steps += burst;
            spent = watch.seconds();
        }
        rate = static_cast<double>(steps) / spent;
    }
    return quantile(std::move(rates), 0.75);
}

} // namespace

MachineSpeed measure_speed(std::int64_t grains, dem::Mode mode, double seconds, int at_once) {
    const auto wanted = static_cast<double>(std::clamp<std::int64_t>(grains, 500, 50'000));
    const dem::World world = made_up_packing(static_cast<int>(std::lround(std::cbrt(wanted))));
    std::vector<double> rates(static_cast<std::size_t>(std::max(at_once, 1)));
    MachineSpeed speed;
    speed.at_once = static_cast<int>(rates.size());
    speed.threads = std::max(1, thread_count() / speed.at_once);
    speed.grains = static_cast<std::int64_t>(world.grains.size());
    run_side_by_side(rates.size(), speed.at_once, [&](std::size_t k) {
        rates[k] = steps_per_second(world, seconds, mode);
    });
    const double sum = std::accumulate(rates.begin(), rates.end(), 0.0);
    speed.particle_steps_per_second = sum / speed.at_once * static_cast<double>(speed.grains);
    return speed;
}

} // namespace suffuse::plan
