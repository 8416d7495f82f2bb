#pragma once
// A world driven until it is balanced, or for a number of steps: what a stage of a case and a call from Python do
// alike. The time step is computed again as contacts come. The caller records, saves and stops between two bursts.

#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/step.hpp"

#include <cstdint>
#include <functional>

namespace suffuse::dem {

/// A settling under way; what a checkpoint saves.
struct Settling {
    BalanceState balance;
    double time_step = 0;            ///< in force [s]
    std::int64_t known_contacts = 0; ///< touching when it was computed
    double stress_before = 0;        ///< mean stress at the start [Pa]
    bool collapsed = false;          ///< the volume is held, and nothing is carried any more
};

/// Settles from the state as it is.
Settling begin_settling(const World& world);

/// Bursts until balanced, or collapsed, under a drag near the critical one of the slowest mode. Settling looks for an
/// equilibrium, not for a motion: the drag keeps inertia from knocking weak contacts open (an imported packing lost 27
/// of its 7,210 active grains without it, and none with it). What has not found it after 20,000 steps is left without
/// drag for three quarters of the time, for grains on their way to new places creep under it.
/// @param plan loading, damping, mode, load; its time step where one is requested, 0: computed
/// @param on_burst called after each burst, with whether it was the last
/// @throws StateError when that takes more than `max_steps`, with what is still missing; and as bounds.hpp says
void settle_world(
    World& world, StepCaches& caches, StepPlan plan, const BalanceSpec& spec, std::int64_t max_steps,
    Settling& settling, const std::function<void(bool is_over)>& on_burst
);

/// A number of steps under way; what a checkpoint saves.
struct Advancing {
    std::int64_t done = 0;           ///< steps
    double time_step = 0;            ///< in force [s]
    std::int64_t known_contacts = 0; ///< touching when it was computed
};

/// Makes `steps` steps, without looking at the balance.
/// @param plan as of settle_world
/// @param most_at_once steps to the next one after which somebody wants to look
/// @param on_burst called after each burst, with its steps
/// @return the stress of the last step [Pa]
/// @throws StateError as bounds.hpp says
Mat3 advance_world(
    World& world, StepCaches& caches, StepPlan plan, std::int64_t steps, Advancing& advancing,
    const std::function<std::int64_t()>& most_at_once, const std::function<void(std::int64_t steps)>& on_burst
);

} // namespace suffuse::dem
