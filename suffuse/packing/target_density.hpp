#pragma once
// A wanted void ratio. Slow and faithful find it by how easily the grains slide while they are compacted: from
// frictionless (densest) over the final friction to adhesion (loosest). Swift finds it by the porosity at its start.

#include "suffuse/grains/material.hpp"
#include "suffuse/packing/spec.hpp"

#include <functional>

namespace suffuse::packing {

struct FoundDensity {
    CompactSpec spec;      ///< with the preparation found
    double void_ratio = 0; ///< [-]
    int trials = 0;
    bool is_met = true; ///< otherwise this one is the nearest, and `if_unreachable` allows that
};

/// @param reach compacts the cloud with a preparation and returns the settled void ratio; what it leaves last is of the
/// preparation that is returned
/// @throws StateError with the reachable range when the wanted void ratio is outside it, or was not met, and
/// `if_unreachable` is an error.
FoundDensity search_void_ratio(
    const CompactSpec& wanted, const grains::Material& final_material,
    const std::function<double(const CompactSpec&)>& reach
);

} // namespace suffuse::packing
