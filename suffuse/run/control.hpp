#pragma once
// The pulse of one sample: shows progress, saves what is needed to go on, and ends the work on request.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/run/overview.hpp"

#include <chrono>
#include <functional>

namespace suffuse::run {

class Control {
public:
    Control(Overview& overview, double checkpoint_interval)
        : overview_(overview), checkpoint_interval_(checkpoint_interval) {}

    /// Begins a stage: what to show.
    void begin(Progress where);

    /// How to save the stage half-way; nothing: a stopped stage begins again.
    void save_with(std::function<void()> save) { save_ = std::move(save); }

    /// The axis whose strain is shown; z unless specified.
    void show_strain_of(int axis) { axis_ = axis; }

    /// Numbers to show from the next beat on, where the stage measures others than those of its world.
    void show_numbers(nlohmann::json numbers) { progress_.state = std::move(numbers); }

    /// Called between bursts. @throws Interrupted, after saving, on request or out of time.
    void beat(std::string_view part, long long steps, const dem::World* world = nullptr);

    /// The same for parts of the library that know no run.
    [[nodiscard]] Pulse pulse();

    void finish(nlohmann::json numbers);

    [[nodiscard]] double stage_seconds() const { return seconds_since(stage_start_); }

private:
    using Clock = std::chrono::steady_clock;

    static double seconds_since(Clock::time_point then) {
        return std::chrono::duration<double>(Clock::now() - then).count();
    }

    Overview& overview_;
    double checkpoint_interval_; ///< [s]
    [[nodiscard]] double rate(long long steps, std::size_t grains);

    Clock::time_point stage_start_ = Clock::now(), saved_ = stage_start_, shown_ = stage_start_;
    Clock::time_point rate_start_;  ///< when steps were first reported
    long long rate_first_step_ = 0; ///< how many they were: a stage that was resumed does not begin at 0
    Progress progress_;
    int axis_ = 2; ///< that is compressed
    std::function<void()> save_;
};

} // namespace suffuse::run
