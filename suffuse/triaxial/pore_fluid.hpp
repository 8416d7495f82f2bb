#pragma once
// Water in the voids of an undrained test: how far it can be compressed, next to the skeleton [Skempton1954]. Grains
// are far stiffer than both.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/world.hpp"

namespace suffuse::triaxial {

struct PoreFluid {
    double bulk_modulus = 0;     ///< [Pa]
    double skeleton_modulus = 0; ///< bulk modulus of the skeleton that the water fills [Pa]
};

/// Pore pressure over the isotropic total stress that brings it: 1/(1 + n K/K_f) [-].
double skempton_b(double porosity, const PoreFluid& fluid);

/// Bulk modulus of a state by a small isotropic strain on a copy [Pa].
/// @throws StateError when it carries no stress, or does not come to rest; Interrupted by `pulse`.
double measure_skeleton_modulus(const dem::World& world, double damping, const Pulse& pulse);

} // namespace suffuse::triaxial
