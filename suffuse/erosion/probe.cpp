#include "suffuse/erosion/probe.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

/// A copy of the equilibrium under observation.
struct Watched {
    dem::World world;
    dem::StepCaches caches;
    std::vector<Vec3> start; ///< positions of the fines [m]
};

std::vector<std::uint32_t> rows_of_fines(const grains::Grains& grains) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] != 0) {
            rows.push_back(g);
        }
    }
    return rows;
}

Watched copy_to_watch(const dem::World& equilibrium, const std::vector<std::uint32_t>& fines, bool hold_coarse) {
    Watched watched{equilibrium, {}, {}};
    grains::Grains& grains = watched.world.grains;
    watched.world.cell.velocity_gradient = {};
    for (std::size_t g = 0; g < grains.size(); ++g) {
        grains.velocity[g] = grains.spin[g] = {};
        grains.motion[g] = hold_coarse && grains.fine[g] == 0 ? grains::Motion::Held : grains::Motion::Free;
    }
    for (const std::uint32_t g : fines) {
        watched.start.push_back(grains.position[g]);
    }
    return watched;
}

void sample_speeds(
    const grains::Grains& grains, const std::vector<std::uint32_t>& fines, std::size_t sample, ProbeResult& result
) {
    for (std::size_t k = 0; k < fines.size(); ++k) {
        result.speed[k][sample] = norm(grains.velocity[fines[k]]);
    }
}

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// What the grains would do free of contacts: a constant force after a linear ramp, reduced by the local damping.
void fill_free_flight(
    const grains::Grains& grains, const std::vector<std::uint32_t>& fines, const ProbeSetting& setting,
    ProbeResult& result
) {
    const double ramp = static_cast<double>(setting.spec.ramp) * setting.time_step;
    const double watch = static_cast<double>(setting.spec.watch) * setting.time_step;
    for (std::size_t k = 0; k < fines.size(); ++k) {
        const double acceleration = result.fluid_force[k] / grains.mass[fines[k]] * (1 - setting.damping);
        result.free_speed.push_back(acceleration * (0.5 * ramp + watch));
        result.free_displacement.push_back(acceleration * (ramp * ramp / 6 + 0.5 * ramp * watch + 0.5 * watch * watch));
    }
}

void fill_scales(
    const dem::World& equilibrium, const std::vector<std::uint32_t>& fines, const ProbeSetting& setting,
    ProbeResult& result
) {
    const grains::Grains& grains = equilibrium.grains;
    double force = 0;
    std::vector<double> viscous_times, final_speeds;
    for (std::size_t k = 0; k < fines.size(); ++k) {
        force += result.fluid_force[k] / static_cast<double>(fines.size());
        viscous_times.push_back(grains.mass[fines[k]] / (6 * pi * setting.fluid.viscosity * grains.radius[fines[k]]));
        final_speeds.push_back(result.speed[k].back());
    }
    const double contact_force = dem::measure_equilibrium(equilibrium).mean_contact_force;
    result.fluid_over_contact = contact_force > 0 ? force / contact_force : 0;
    const double noise = median(result.twin_speed);
    result.signal_over_twin = noise > 0 ? median(final_speeds) / noise : 0;
    result.viscous_time = median(viscous_times);
    result.beyond_viscous_time =
        static_cast<double>(setting.spec.ramp + setting.spec.watch) * setting.time_step > result.viscous_time;
}

ProbeResult describe_fines(
    const dem::World& equilibrium, const std::vector<std::uint32_t>& fines, const grains::GrainLoad& load,
    const ProbeSetting& setting
) {
    ProbeResult result;
    result.gradient = setting.gradient;
    result.unbalanced_force = dem::measure_equilibrium(equilibrium).unbalanced_force;
    result.ramp = setting.spec.ramp;
    result.watch = setting.spec.watch;
    result.time_step = setting.time_step;
    const std::vector<int> contacts = dem::coordination(equilibrium);
    for (const std::uint32_t g : fines) {
        result.id.push_back(equilibrium.grains.id[g]);
        result.diameter.push_back(2 * equilibrium.grains.radius[g]);
        result.fluid_force.push_back(norm(load.force[g]));
        result.coordination.push_back(contacts[g]);
    }
    result.speed.resize(fines.size());
    fill_free_flight(equilibrium.grains, fines, setting, result);
    return result;
}

} // namespace

ProbeResult watch_fines(
    const dem::World& equilibrium, const grains::GrainLoad& load, const ProbeSetting& setting, const Pulse& pulse
) {
    const std::vector<std::uint32_t> fines = rows_of_fines(equilibrium.grains);
    ProbeResult result = describe_fines(equilibrium, fines, load, setting);
    grains::GrainLoad on_fines{std::vector<Vec3>(equilibrium.grains.size())};
    for (const std::uint32_t g : fines) {
        on_fines.force[g] = load.force[g];
    }

    Watched probe = copy_to_watch(equilibrium, fines, setting.spec.hold_coarse);
    Watched twin = copy_to_watch(equilibrium, fines, setting.spec.hold_coarse);
    dem::StepPlan plan;
    plan.dt = setting.time_step;
    plan.damping = setting.damping;
    plan.loading = dem::constant_volume();
    dem::StepPlan loaded = plan;
    loaded.load = &on_fines;

    const std::int64_t steps = setting.spec.ramp + setting.spec.watch;
    std::size_t sample = 0;
    for (std::int64_t k = 0; k <= steps; ++k) {
        // Samples at full force and after each tenth of the watch.
        const auto next = setting.spec.ramp + static_cast<std::int64_t>(sample) * setting.spec.watch / probe_samples;
        if (k == next && sample <= probe_samples) {
            sample_speeds(probe.world.grains, fines, sample++, result);
        }
        if (k == steps) {
            break;
        }
        loaded.load_share = std::min(1.0, static_cast<double>(k + 1) / static_cast<double>(setting.spec.ramp));
        dem::step(probe.world, probe.caches, loaded);
        dem::step(twin.world, twin.caches, plan);
        if (k % dem::burst_steps == 0) {
            beat(pulse, "probe", k);
        }
    }

    for (std::size_t k = 0; k < fines.size(); ++k) {
        const std::uint32_t g = fines[k];
        result.twin_speed.push_back(norm(twin.world.grains.velocity[g]));
        const Vec3 against_twin = probe.world.grains.position[g] - twin.world.grains.position[g];
        const double force = result.fluid_force[k];
        result.displacement.push_back(force > 0 ? dot(against_twin, load.force[g]) / force : 0);
    }
    fill_scales(equilibrium, fines, setting, result);
    return result;
}

} // namespace suffuse::erosion
