#include "suffuse/triaxial/probed_sample.hpp"

#include "suffuse/dem/relax.hpp"

namespace suffuse::triaxial {

void burst(
    LoadedSample& sample, const cell::Loading& loading, double time_step, double damping, const dem::BalanceSpec& goal
) {
    dem::StepPlan plan;
    plan.dt = time_step;
    plan.damping = damping;
    plan.drag = dem::slowest_mode_drag(sample.world.grains.size(), time_step);
    plan.loading = loading;
    sample.rests = dem::settle_burst(sample.world, sample.caches, plan, goal, sample.balance);
}

} // namespace suffuse::triaxial
