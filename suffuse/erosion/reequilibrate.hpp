#pragma once
// Step 6 of the procedure: the skeleton finds a new equilibrium, first at constant volume (how much stress is lost),
// then under the stresses held before (how much it settles). Figures 13 and 14.

#include "suffuse/erosion/loop.hpp"
#include "suffuse/erosion/pass_under_way.hpp"

namespace suffuse::erosion {

/// Whether a skeleton has carried less than a tenth of the mean stress that it should carry [Pa] for 400,000 steps.
bool is_adrift(double held, Resettlement& so_far);

/// Fills in what the pass starts from.
void describe_before(const dem::World& world, PassResult& pass);

/// Runs both phases, fills in what they did; the path from the first step after the removal on is in `so_far` then. A
/// skeleton that strains further than it may has failed, is left there, and the pass's verdict says so.
/// @param so_far goes on after a stop, and with the world it is true at each beat
void reequilibrate(
    dem::World& world, const ResettleSpec& spec, const ErosionResult& before, const Surroundings& around,
    PassResult& pass, Resettlement& so_far
);

} // namespace suffuse::erosion
