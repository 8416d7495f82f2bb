#pragma once
// Voids of a packing, each of one pore or of several. A tetrahedron of the triangulation is no natural void: neighbors
// often share one, and the facet between them is then no constriction but a cut through it. Pores are distinguished by
// their void spheres, each of which touches the pore's four grains from between [AlRaoush 2003] [Reboul 2008].

#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/network.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace suffuse::pores {

/// Which neighboring pores belong to one void, besides those of coincident centers, which always do.
enum class VoidMerge {
    None,    ///< no others: each facet is a constriction, the reference's choice
    Center,  ///< the center of the void sphere of one lies in that of the other
    Overlap, ///< their void spheres overlap
};

inline constexpr std::array every_merge = {VoidMerge::None, VoidMerge::Center, VoidMerge::Overlap};

/// "none", "center" or "overlap".
constexpr std::string_view name_of(VoidMerge merge) {
    return merge == VoidMerge::None ? "none" : merge == VoidMerge::Center ? "center" : "overlap";
}

struct VoidSphere {
    Vec3 center;       ///< [m]
    double radius = 0; ///< not above 0 where the grains leave no room for one [m]
};

/// The sphere that touches four spheres around `x` with radii `r` from between them [m]. Radius 0 where none does, and
/// where their centers lie in one plane.
VoidSphere void_sphere(const std::array<Vec3, 4>& x, const std::array<double, 4>& r);

/// The void sphere of each pore, at its own place. Pores too flat for one take that of a pore of their body.
/// `position` and `radius` are those of the network [m].
std::vector<VoidSphere>
void_spheres(const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius);

/// The throats of `network` that lead from one void into another or into its image, in rising order. Facets that cut
/// one window between two voids, so that their spheres coincide, count once, unless `merge` is None. A void that runs
/// through the cell and meets itself is one with its images. `position` and `radius` are those of the network [m]; None
/// needs neither.
std::vector<std::uint32_t> throats_between_voids(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, VoidMerge merge
);

} // namespace suffuse::pores
