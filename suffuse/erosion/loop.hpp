#pragma once
// The erosion procedure of the paper (its section 4 and Figure 7): equilibrium, flow, probe, constrictions, extraction,
// new equilibrium, and again.

#include "suffuse/base/error.hpp"
#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/own_rule.hpp"
#include "suffuse/erosion/pass_under_way.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"
#include "suffuse/flow/fluid.hpp"

#include <vector>

namespace suffuse::erosion {

/// What the loop needs besides its own settings.
struct Surroundings {
    flow::Fluid fluid;
    dem::BalanceSpec balance;
    double damping = dem::usual_damping; ///< local [-]
    dem::Mode mode =
        dem::Mode::Reference;      ///< of the new equilibrium; relaxation and probe are always of reference mode
    Pulse pulse;                   ///< may throw Interrupted: the world is then as it was before the pass
    const OwnRule* rule = nullptr; ///< judges in place of the settings'; it may throw, too
};

/// All grains are fines: nothing holds or carries.
struct NoSkeleton : StateError {
    using StateError::StateError;
};

/// One pass from an equilibrium; appends to `result` and returns whether the procedure should go on.
/// @param now true at each beat; a pass that was stopped goes on from it, and when it is over it is that of the next
/// @throws SolverError, GeometryError, NoSkeleton, StateError, UsageError; the world is then as before.
bool erode_once(
    dem::World& world, const ErodeSpec& spec, const Surroundings& around, ErosionResult& result, PassUnderWay& now
);

/// @throws UsageError where an erosion of this kind uses no rule.
void check_own_rule(const ErodeSpec& spec, const OwnRule& rule);

/// Begins a result at the equilibrium `world`. @throws StateError where that carries no stress.
ErosionResult begin_erosion(const dem::World& world);

/// Mass that has left over that of the fines, or of all grains, before the first pass [-].
double eroded_share(const dem::World& world, double initial_mass, ErodedTarget::Of of);

/// Whether nothing will leave any more after `pass`, the next one of `so_far`. Where grains travel, a pass from which
/// none leaves may be chance: it takes three.
bool is_exhausted(const ErodeSpec& spec, const ErosionResult& so_far, const PassResult& pass);

/// The probe alone at several gradients, nothing removed (Figure 9). One flow solution serves all gradients.
std::vector<ProbeResult>
probe_gradients(const dem::World& world, const DetachStageSpec& spec, const Surroundings& around);

} // namespace suffuse::erosion
