#pragma once
// The water's velocity from pore to pore, and how far its ways wind.

#include "suffuse/base/vec3.hpp"
#include "suffuse/pores/network.hpp"

#include <array>
#include <span>
#include <vector>

namespace suffuse::flow {

/// Centroid of what three grains leave of the triangle of their centers [m]; that of the triangle where they leave less
/// than a hundredth of it. @param x their centers, r their radii [m]
Vec3 void_centroid(const std::array<Vec3, 3>& x, const std::array<double, 3>& r);

/// Mean velocity of the water in each pore [m/s]. Where as much flows in as out, the integral of the velocity is the
/// sum of what leaves through each throat times the place where it leaves (divergence theorem); that is taken to be the
/// centroid of the throat's void. Weighted by the pores' voids, the velocities add up to the cell's volume times
/// `mean_velocity`, whatever the places. Pores of one body of water share one velocity; it is zero where a body has no
/// void. @param flux per throat [m3/s]; `position` and `radius` as given to build_network [m]
std::vector<Vec3> pore_velocities(
    const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius,
    std::span<const double> flux
);

/// Hydraulic tortuosity: the mean speed of the water over the speed of its mean motion, by volume; 1 where all of it
/// flows the same way, not a number where nothing flows [-] [Duda 2011]. How the water winds within a pore is not in
/// it: a lower bound.
double tortuosity(const pores::PoreNetwork& network, std::span<const Vec3> velocity);

} // namespace suffuse::flow
