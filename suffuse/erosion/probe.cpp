#include "suffuse/erosion/probe.hpp"

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/grains/load.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace suffuse::erosion {
namespace {

std::vector<std::uint32_t> rows_of_fines(const grains::Grains& grains) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        if (grains.fine[g] != 0) {
            rows.push_back(g);
        }
    }
    return rows;
}

dem::World copy_to_watch(const dem::World& equilibrium, bool hold_coarse) {
    dem::World world = equilibrium;
    grains::Grains& grains = world.grains;
    world.cell.velocity_gradient = {};
    for (std::size_t g = 0; g < grains.size(); ++g) {
        grains.velocity[g] = grains.spin[g] = {};
        grains.motion[g] = hold_coarse && grains.fine[g] == 0 ? grains::Motion::Held : grains::Motion::Free;
    }
    return world;
}

/// What is kept of a copy that was watched, a row a fine grain.
struct Motion {
    std::vector<std::array<double, probe_samples + 1>>
        speed;                  ///< at full force, and after each tenth of the watch [m/s]
    std::vector<Vec3> position; ///< at the end [m]
};

/// A copy of the equilibrium under observation, with the fluid's forces on its fines or without.
class Watched {
public:
    Watched(
        const dem::World& equilibrium, const std::vector<std::uint32_t>& fines, const ProbeLoad* load,
        const ProbeSetting& setting
    )
        : fines_(fines), spec_(setting.spec), world_(copy_to_watch(equilibrium, setting.spec.hold_coarse)) {
        plan_.dt = setting.time_step;
        plan_.damping = setting.damping;
        plan_.loading = dem::constant_volume();
        motion_.speed.resize(fines.size());
        if (load == nullptr) {
            return;
        }
        load_.emplace().force.resize(equilibrium.grains.size());
        for (const std::uint32_t g : fines) {
            load_->force[g] = load->force[g];
        }
    }

    /// Goes on to the given step.
    void advance_to(std::int64_t last) {
        plan_.load = load_ ? &*load_ : nullptr;
        plan_.load_ramp = spec_.ramp;
        sample_speeds();
        while (step_ < last) {
            const std::int64_t burst = std::min(last, next_sample()) - step_;
            plan_.load_steps = step_;
            dem::advance(world_, caches_, plan_, burst);
            step_ += burst;
            sample_speeds();
        }
    }

    Motion finish() {
        for (const std::uint32_t g : fines_) {
            motion_.position.push_back(world_.grains.position[g]);
        }
        return std::move(motion_);
    }

private:
    [[nodiscard]] std::int64_t next_sample() const {
        return sample_ <= probe_samples ? spec_.ramp + sample_ * spec_.watch / probe_samples
                                        : std::numeric_limits<std::int64_t>::max();
    }

    /// At full force and after each tenth of the watch, the same again where it has been done.
    void sample_speeds() {
        while (step_ == next_sample()) {
            for (std::size_t k = 0; k < fines_.size(); ++k) {
                motion_.speed[k][static_cast<std::size_t>(sample_)] = norm(world_.grains.velocity[fines_[k]]);
            }
            ++sample_;
        }
    }

    const std::vector<std::uint32_t>& fines_;
    const ProbeSpec& spec_;
    dem::World world_;
    dem::StepCaches caches_;
    dem::StepPlan plan_;
    std::optional<grains::GrainLoad> load_;
    Motion motion_;
    std::int64_t step_ = 0;
    int sample_ = 0;
};

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
    const double noise = upper_quantile(result.twin_speed, 0.5);
    result.signal_over_twin = noise > 0 ? upper_quantile(final_speeds, 0.5) / noise
                                        : std::numeric_limits<double>::infinity(); // a twin at rest
    result.viscous_time = fines.empty() ? 0 : upper_quantile(viscous_times, 0.5);
    result.beyond_viscous_time =
        static_cast<double>(setting.spec.ramp + setting.spec.watch) * setting.time_step > result.viscous_time;
}

ProbeResult describe_fines(
    const dem::World& equilibrium, const std::vector<std::uint32_t>& fines, const ProbeLoad& load,
    const ProbeSetting& setting
) {
    ProbeResult result;
    result.gradient = load.gradient;
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
    fill_free_flight(equilibrium.grains, fines, setting, result);
    return result;
}

/// Motions of the twin, then of the copy under each load: `at_once` of them side by side, a burst of steps at a time.
std::vector<Motion> watch(
    const dem::World& equilibrium, const std::vector<std::uint32_t>& fines, std::span<const ProbeLoad> loads,
    const ProbeSetting& setting, const Pulse& pulse
) {
    const std::size_t copies = loads.size() + 1;
    const std::size_t at_once = std::min(copies, static_cast<std::size_t>(thread_count()));
    const std::int64_t steps = setting.spec.ramp + setting.spec.watch;
    std::vector<Motion> motions;
    std::int64_t done = 0; // steps of the copies watched so far
    for (std::size_t first = 0; first < copies; first += at_once) {
        std::vector<Watched> side_by_side;
        side_by_side.reserve(at_once);
        for (std::size_t k = first; k < std::min(copies, first + at_once); ++k) {
            side_by_side.emplace_back(equilibrium, fines, k == 0 ? nullptr : &loads[k - 1], setting);
        }
        for (std::int64_t step = 0; step < steps; step += dem::burst_steps) {
            beat(pulse, "probe", done + step);
            run_side_by_side(side_by_side.size(), static_cast<int>(side_by_side.size()), [&](std::size_t k) {
                side_by_side[k].advance_to(std::min(steps, step + dem::burst_steps));
            });
        }
        done += steps;
        for (Watched& watched : side_by_side) {
            motions.push_back(watched.finish());
        }
    }
    return motions;
}

} // namespace

std::vector<ProbeResult> watch_fines(
    const dem::World& equilibrium, std::span<const ProbeLoad> loads, const ProbeSetting& setting, const Pulse& pulse
) {
    const std::vector<std::uint32_t> fines = rows_of_fines(equilibrium.grains);
    std::vector<Motion> motions = watch(equilibrium, fines, loads, setting, pulse);
    const Motion& twin = motions.front();
    std::vector<ProbeResult> results;
    for (std::size_t l = 0; l < loads.size(); ++l) {
        Motion& probe = motions[l + 1];
        ProbeResult& result = results.emplace_back(describe_fines(equilibrium, fines, loads[l], setting));
        for (std::size_t k = 0; k < fines.size(); ++k) {
            result.twin_speed.push_back(twin.speed[k].back());
            const double force = result.fluid_force[k];
            const Vec3 against_twin = probe.position[k] - twin.position[k];
            result.displacement.push_back(force > 0 ? dot(against_twin, loads[l].force[fines[k]]) / force : 0);
        }
        result.speed = std::move(probe.speed);
        fill_scales(equilibrium, fines, setting, result);
    }
    return results;
}

} // namespace suffuse::erosion
