#pragma once
// Sizes of the constrictions of a skeleton: of the largest spheres that pass the facets of its weighted Delaunay
// triangulation (facet_room.hpp), each facet counted once (the paper's choice, as in Yade), or those facets alone that
// lead from one void of several pores into another. Facets between pores of coincident centers, which only cut one void
// in two, are never any.

#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/network.hpp"
#include "suffuse/pores/voids.hpp"

#include <span>
#include <vector>

namespace suffuse::pores {

struct Constrictions {
    std::vector<double> diameter; ///< one row a facet [m]
    std::vector<Vec3> center;     ///< of the sphere, in the facet [m]
    double mean = 0;              ///< by number of facets, like the next two [m]
    double median = 0;            ///< [m]
    double d35 = 0;               ///< 35 % are smaller [m]
};

/// Fills the columns `inscribed_radius` and `center` of the throats of the grains at `position` with `radius` [m].
void measure_constrictions(PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius);

/// Constrictions of a network, each facet one.
Constrictions find_constrictions(const PoreNetwork& network);

/// Constrictions of the network of the grains at `position` with `radius` [m], between voids merged in this way.
Constrictions find_constrictions(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, VoidMerge merge
);

/// Constrictions among grains at `position` with `radius` alone, in the periodic cell `h` [m].
/// @throws GeometryError for input that is not a packing.
Constrictions find_constrictions(
    const Mat3& h, std::span<const Vec3> position, std::span<const double> radius, VoidMerge merge = VoidMerge::None
);

} // namespace suffuse::pores
