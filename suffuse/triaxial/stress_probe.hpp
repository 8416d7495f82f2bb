#pragma once
// Is a state stable? Small stress increments of all axisymmetric directions are put on copies of it, and the
// second-order work of each, d stress : d strain, is looked at: where it is not above zero the sample can fail without
// more load [Hill1958] [Hadda2013]. World in, answers out.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/triaxial/spec.hpp"

namespace suffuse::triaxial {

enum class Answer : std::int32_t {
    Rests,  ///< found a new equilibrium
    Creeps, ///< strains slowly for as long as it was watched
    Fails   ///< strains beyond the limit: no equilibrium under this load
};

/// One direction.
struct StressProbe {
    double angle = 0;             ///< of the increment in the plane (sqrt(2) d lateral, d axial), from lateral [rad]
    Vec3 stress;                  ///< reached, along the axes of the cell, beyond the state probed [Pa]
    Vec3 strain;                  ///< logarithmic, compression positive [-]
    double second_order_work = 0; ///< stress . strain [J/m3]
    double normalized = 0;        ///< over the product of the norms, -1 to 1 [-]
    Answer answer = Answer::Rests;
    std::int64_t steps = 0;

    /// No equilibrium, or none that costs work.
    [[nodiscard]] bool is_unstable() const { return answer == Answer::Fails || second_order_work <= 0; }
};

/// What all probes start from.
struct ProbedState {
    dem::World world; ///< at rest under its own stress; grains with lent inertia, of equal quickness
    Vec3 stress;      ///< along the axes of the cell [Pa]
    double time_step = 0;
    std::int64_t steps = 0; ///< until it rested
    double drift = 0;       ///< norm of the strain of a probe without load: what strains below it mean nothing [-]
};

/// Brings a copy of the state to rest under the stress that it carries, and watches it without load.
/// @throws StateError when it carries none, or does not come to rest; Interrupted by `pulse`.
ProbedState rest_for_probes(const dem::World& world, const StressProbeSpec& spec, double damping, const Pulse& pulse);

/// Direction `number` of `spec.directions`.
StressProbe
probe_direction(const ProbedState& state, const StressProbeSpec& spec, int number, double damping, const Pulse& pulse);

} // namespace suffuse::triaxial
