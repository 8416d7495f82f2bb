#pragma once
// How near a state is to equilibrium, measured from what the last step left; cheap enough for every fifty steps.

#include "suffuse/dem/world.hpp"
#include "suffuse/grains/load.hpp"

namespace suffuse::dem {

struct Equilibrium {
    /// Mean resultant over grains with two contacts or more that nobody holds / mean contact force [-]
    double unbalanced_force = 0;
    double unbalanced_force_all = 0; ///< the same, rattlers included [-]
    double mean_contact_force = 0;   ///< normal and shear [N]
    double kinetic_energy = 0;       ///< of the motion against the mean motion, spin included [J]
    double max_overlap_ratio = 0;    ///< overlap / smaller radius [-]
    std::int64_t contacts = 0;       ///< touching
    std::int64_t rattlers = 0;       ///< grains with fewer than 2 contacts
    std::int64_t single_contact = 0; ///< of those, with one contact
};

/// @param load that acts on the grains besides their contacts, if any
Equilibrium measure_equilibrium(const World& world, const grains::GrainLoad* load = nullptr);

} // namespace suffuse::dem
