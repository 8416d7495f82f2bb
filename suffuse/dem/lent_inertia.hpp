#pragma once
// Inertia lent to grains while a sample is prepared or probed, so that the time step can be longer: a quasi-static path
// does not depend on it. All factors are powers of two: giving back is exact.

#include "suffuse/dem/world.hpp"

namespace suffuse::dem {

/// What grains have beyond their own.
struct Lent {
    bool mass = false;     ///< grains below the median size (by mass) are as heavy as makes all equally quick
    bool rotation = false; ///< moments of inertia are four times as large, and of grains below the median size so large
                           ///< that they roll on the largest one no quicker than the median grain does
    bool gently = false; ///< mass grows as the ratio of the sizes only, not as its square: what is lighter packs denser
    bool fines_rotation = false; ///< moments of inertia of grains below the median size alone are so large that they
                                 ///< roll between two of the largest no quicker than on their like

    friend bool operator==(const Lent&, const Lent&) = default;
};

/// Where rotation is lent, every grain turns so many times as slowly: the root of the factor on its moment of inertia.
inline constexpr double slower_turning = 2;

/// What mass and moment of inertia of a grain are multiplied by.
struct InertiaFactors {
    double mass = 1, turning = 1; ///< the second beyond the first, which turning grains feel too
};

/// Radii of the grain, of the grain of the median size by mass, and of the largest [m].
InertiaFactors lent_factors(const Lent& lent, double radius, double median, double largest);

/// Changes the grains' inertia from what `has` lends to what `wanted` does. @param median_diameter by mass [m]
void lend_inertia(World& world, double median_diameter, const Lent& has, const Lent& wanted);

} // namespace suffuse::dem
