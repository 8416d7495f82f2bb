#include "suffuse/dem/drive_world.hpp"

#include "suffuse/cell/drive.hpp"
#include "suffuse/cell/hold_stress.hpp"
#include "suffuse/dem/bounds.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/relax.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <algorithm>

namespace suffuse::dem {
namespace {

double computed_time_step(const World& world, const StepPlan& plan) {
    return stable_time_step(world, {plan.damping, cell::stress_to_bear(plan.loading, world.servo)});
}

/// Drag calms the vibrations of a skeleton, and grains that fall into new places creep through it: under a stress that
/// small compared with the springs for millions of steps. What does not rest soon has its drag in one span of four.
bool falls_freely(std::int64_t steps) {
    constexpr std::int64_t span = 20'000; // most samples rest within the first
    return steps / span % 4 != 0;
}

/// Later stages hold the stresses that the world was driven to, however the driving ends. Not before: what is held
/// takes part in the choice of a time step.
class HoldAtTheEnd {
public:
    HoldAtTheEnd(World& world, const cell::Loading& loading) : world_(world), loading_(loading) {}

    ~HoldAtTheEnd() { cell::hold_stress(loading_, world_.servo); }

    HoldAtTheEnd(const HoldAtTheEnd&) = delete;
    HoldAtTheEnd& operator=(const HoldAtTheEnd&) = delete;

private:
    World& world_;
    const cell::Loading& loading_;
};

} // namespace

Settling begin_settling(const World& world) {
    Settling settling;
    settling.stress_before = mean_stress(mean_stress_tensor(world));
    return settling;
}

void settle_world(
    World& world, StepCaches& caches, StepPlan plan, const BalanceSpec& spec, std::int64_t max_steps,
    Settling& settling, const std::function<void(bool is_over)>& on_burst
) {
    const HoldAtTheEnd held(world, plan.loading);
    const double wanted = plan.dt;
    BalanceState& state = settling.balance;
    for (bool is_over = false; !is_over;) {
        if (wanted > 0) {
            settling.time_step = wanted;
        } else {
            renew_time_step(settling, state.steps, state.equilibrium.contacts, [&] {
                return computed_time_step(world, plan);
            });
        }
        plan.dt = settling.time_step;
        plan.drag = falls_freely(state.steps) ? 0 : slowest_mode_drag(world.grains.size(), plan.dt);
        check_strain_of_step(plan.loading, plan.dt);
        const bool is_settled = settle_burst(world, caches, plan, spec, state);
        check_room(world);
        settling.collapsed = !is_settled && carries_nothing(plan.loading, spec, state, settling.stress_before);
        is_over = is_settled || settling.collapsed;
        on_burst(is_over);
        if (!is_over && state.steps >= max_steps) {
            report_not_balanced(plan.loading, spec, state);
        }
    }
}

Mat3 advance_world(
    World& world, StepCaches& caches, StepPlan plan, std::int64_t steps, Advancing& advancing,
    const std::function<std::int64_t()>& most_at_once, const std::function<void(std::int64_t steps)>& on_burst
) {
    const HoldAtTheEnd held(world, plan.loading);
    const double wanted = plan.dt;
    StepReport report;
    while (advancing.done < steps) {
        if (wanted > 0) {
            advancing.time_step = wanted;
        } else {
            renew_time_step(advancing, advancing.done, measure_equilibrium(world).contacts, [&] {
                return computed_time_step(world, plan);
            });
        }
        plan.dt = advancing.time_step;
        const std::int64_t burst = std::min(
            {steps - advancing.done, most_at_once(), burst_steps,
             time_step_interval - advancing.done % time_step_interval}
        );
        check_strain_of_step(plan.loading, plan.dt);
        report = advance(world, caches, plan, burst);
        advancing.done += burst;
        check_room(world);
        on_burst(burst);
    }
    return report.stress;
}

} // namespace suffuse::dem
