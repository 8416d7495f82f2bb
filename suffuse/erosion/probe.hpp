#pragma once
// Step 3 of the paper's procedure: the coarse grains of a copy are held, the fluid's forces act on its fines, and what
// moves is watched. Beside it a twin without fluid, same hold and same steps, shows what would have moved anyway.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/grains/load.hpp"

namespace suffuse::erosion {

struct ProbeSetting {
    ProbeSpec spec;
    flow::Fluid fluid;
    double gradient = 0;  ///< hydraulic gradient that `load` belongs to [-]
    double time_step = 0; ///< [s]
    double damping = 0.2; ///< local [-]
};

/// Watches the fines of a copy of `equilibrium` under `load` (a row a grain; only the fines' rows act) and fills in all
/// of the result but the verdicts of the rules.
ProbeResult watch_fines(
    const dem::World& equilibrium, const grains::GrainLoad& load, const ProbeSetting& setting, const Pulse& pulse = {}
);

} // namespace suffuse::erosion
