#pragma once
// A copy of a state, brought from one equilibrium to the next: what stress probes and strain probes have in common.

#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/step.hpp"

namespace suffuse::triaxial {

/// Where a load has brought a world so far.
struct LoadedSample {
    dem::World world;
    dem::StepCaches caches;
    dem::BalanceState balance;
    bool rests = false;
};

/// One burst, over-damped, so that no inertia takes a contact over its limit that the load itself leaves below.
void burst(
    LoadedSample& sample, const cell::Loading& loading, double time_step, double damping, const dem::BalanceSpec& goal
);

} // namespace suffuse::triaxial
