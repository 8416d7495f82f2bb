#pragma once
// Step 6 of the procedure: the skeleton finds a new equilibrium, first at constant volume (how much stress is lost),
// then under the stresses held before (how much it settles). Figures 13 and 14.

#include "suffuse/erosion/loop.hpp"

namespace suffuse::erosion {

/// Fills in what the pass starts from.
void describe_before(const dem::World& world, PassResult& pass);

/// Runs both phases, fills in what they did, and returns the path from the first step after the removal on.
/// A skeleton that strains further than it may has failed, is left there, and the pass's verdict says so.
std::vector<PathRow> reequilibrate(
    dem::World& world, const ResettleSpec& spec, const ErosionResult& so_far, const Surroundings& around,
    PassResult& pass
);

} // namespace suffuse::erosion
