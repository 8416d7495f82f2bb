#pragma once
// Conductance of a throat from its geometry [Chareyre 2012], as in Yade 2023.02a without its clamp, whose bounds depend
// on the unit system.

#include "suffuse/pores/network.hpp"

#include <algorithm>
#include <vector>

namespace suffuse::flow {

/// Pore centers count as no closer than this share of the throat's hydraulic diameter.
inline constexpr double least_length = 1e-6;

/// Flux per pressure difference [m3/(Pa s)] of a throat of void area [m2], hydraulic radius [m] and length [m] in a
/// fluid of viscosity [Pa s].
inline double throat_conductance(double void_area, double hydraulic_radius, double length, double viscosity) {
    const double diameter = 2 * std::abs(hydraulic_radius);
    return void_area * diameter * diameter / (8 * viscosity * std::max(length, least_length * diameter));
}

/// Conductance of each throat [m3/(Pa s)]; 0 for throats inside a body of water, which drive nothing.
std::vector<double> conductances(const pores::PoreNetwork& network, double viscosity);

} // namespace suffuse::flow
