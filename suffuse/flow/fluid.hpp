#pragma once
// The pore fluid, how it passes throats, and what is asked of it.

#include "suffuse/base/vec3.hpp"

#include <cstdint>
#include <optional>

namespace suffuse::flow {

/// What the conductance of a throat and the forces on its grains follow from.
enum class Conductance {
    Bounded, ///< bounded drag, and momentum exchanged between throats: for any ratio of sizes
    Yade,    ///< the hydraulic radius of each throat by itself, as in Yade 2023.02a
};

struct Fluid {
    double density = 1000;   ///< [kg/m3]
    double viscosity = 1e-3; ///< [Pa s]
    Conductance conductance = Conductance::Yade;
};

/// `do = "flow"`: steady seepage through the frozen packing.
struct FlowSpec {
    double gradient = 0;                      ///< hydraulic gradient i [-]
    Vec3 direction = {0, 0, 1};               ///< where the water goes: grad p = -i rho_w g direction
    bool tensor = false;                      ///< solve three directions and report the permeability tensor
    std::optional<std::int64_t> resolve = {}; ///< boxes across the Sauter diameter of a second solution, on a grid
};

} // namespace suffuse::flow
