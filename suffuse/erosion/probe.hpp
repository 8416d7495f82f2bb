#pragma once
// Step 3 of the paper's procedure: the coarse grains of a copy are held, the fluid's forces act on its fines, and what
// moves is watched. With it a twin without fluid, same hold and same steps, shows what would have moved anyway.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"

#include <span>
#include <vector>

namespace suffuse::erosion {

struct ProbeSetting {
    ProbeSpec spec;
    flow::Fluid fluid;
    double time_step = 0;                ///< [s]
    double damping = dem::usual_damping; ///< local [-]
};

/// What the fluid does at one hydraulic gradient.
struct ProbeLoad {
    double gradient = 0;     ///< hydraulic [-]
    std::vector<Vec3> force; ///< a row a grain; only the fines' rows act [N]
};

/// Watches the fines of copies of `equilibrium`, one under each load and one, the twin of all of them, under none.
/// As many copies as there are threads run side by side, and no more are held at a time.
/// @return for each load all of the result but the verdicts of the rules
std::vector<ProbeResult> watch_fines(
    const dem::World& equilibrium, std::span<const ProbeLoad> loads, const ProbeSetting& setting,
    const Pulse& pulse = {}
);

} // namespace suffuse::erosion
