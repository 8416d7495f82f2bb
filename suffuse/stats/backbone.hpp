#pragma once
// The part of a packing that carries: what is left when grains with too few contacts to be held are taken off again and
// again, for a grain may have rested on one of them. Its coordination z* is what isostaticity speaks of
// [Agnolin & Roux 2007]; Zm of coordination.hpp takes off once, and only what has fewer than two contacts.

#include "suffuse/dem/world.hpp"

#include <cstdint>

namespace suffuse::stats {

struct Backbone {
    std::int64_t grains = 0, contacts = 0; ///< that are left
    double coordination = 0;               ///< z* = 2 contacts / grains; 0 where nothing is left [-]
    std::int64_t rattlers = 0;             ///< taken off
};

/// Least contacts that can hold a sphere in place: four without friction, two with it.
int least_contacts(const grains::Material& material);

/// @param least grains with fewer contacts among those that are left are taken off; a grain that touches its own image
/// counts that twice
Backbone measure_backbone(const dem::World& world, int least);

/// Normal stiffness of two equal grains over pressure and diameter, kn/(p d) = E/(2 p): how stiff the grains are,
/// whatever their size [-]. Overlaps are about 1/kappa of a diameter. Zero where the mean stress is not compressive.
double stiffness_to_pressure(const dem::World& world);

} // namespace suffuse::stats
