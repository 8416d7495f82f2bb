#pragma once
// From pressures to the force of the fluid on each grain [Chareyre 2012; reference 3.1]: at each throat the pressure
// difference acts on the grains' sections of its facet, and, by shares of the wetted surface, on its void area.

#include "suffuse/base/vec3.hpp"
#include "suffuse/flow/pressure.hpp"
#include "suffuse/pores/network.hpp"

#include <span>
#include <vector>

namespace suffuse::flow {

/// Force on each grain [N], positions and radii as given to build_network. `gradient`: the mean pressure gradient that
/// the pressures were solved for [Pa/m].
std::vector<Vec3> grain_forces(
    const pores::PoreNetwork& network, std::span<const double> pressure, const Vec3& gradient,
    std::span<const Vec3> position, std::span<const double> radius
);

} // namespace suffuse::flow
