#include "suffuse/run/control.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"

namespace suffuse::run {
namespace {

nlohmann::json state_to_show(const dem::World& world, int axis) {
    const Mat3 stress = dem::mean_stress_tensor(world);
    return {
        {"void_ratio", dem::void_ratio(world)},
        {"mean_stress", dem::mean_stress(stress)},
        {"deviator_stress", dem::deviator_stress(stress)},
        {"unbalanced_force", dem::measure_equilibrium(world).unbalanced_force},
        {"axial_strain", dem::strain(world)[axis]},
    };
}

} // namespace

void Control::begin(Progress where) {
    progress_ = std::move(where);
    save_ = nullptr;
    axis_ = 2;
    rate_first_step_ = -1;
    stage_start_ = saved_ = Clock::now();
    shown_ = Clock::time_point{};
    beat("", 0);
}

void Control::beat(std::string_view part, long long steps, const dem::World* world) {
    if (overview_.is_interested(seconds_since(shown_))) {
        shown_ = Clock::now();
        progress_.part = part;
        progress_.steps = steps;
        progress_.stage_seconds = stage_seconds();
        if (world != nullptr) {
            progress_.state = state_to_show(*world, axis_);
            progress_.particle_steps_per_second = rate(steps, world->grains.size());
        }
        overview_.show(progress_);
    }
    const bool stop = overview_.should_stop();
    if (save_ && (stop || seconds_since(saved_) > checkpoint_interval_)) {
        save_();
        saved_ = Clock::now();
    }
    if (stop) {
        throw Interrupted("stop requested, or out of time");
    }
}

/// Grain steps per second since steps were first reported; a search that begins anew counts anew.
double Control::rate(long long steps, std::size_t grains) {
    if (rate_first_step_ < 0 || steps < rate_first_step_) {
        rate_first_step_ = steps;
        rate_start_ = Clock::now();
    }
    const double seconds = seconds_since(rate_start_);
    return seconds > 0 ? static_cast<double>(steps - rate_first_step_) * static_cast<double>(grains) / seconds : 0;
}

Pulse Control::pulse() {
    return [this](std::string_view part, long long steps) { beat(part, steps); };
}

void Control::finish(nlohmann::json numbers) {
    progress_.state = std::move(numbers);
    progress_.stage_seconds = stage_seconds();
    progress_.stage_finished = true;
    overview_.show(progress_);
}

} // namespace suffuse::run
