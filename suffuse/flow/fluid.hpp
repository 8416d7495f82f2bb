#pragma once
// The pore fluid, how it passes throats, and which flow to solve.

#include "suffuse/base/vec3.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace suffuse::flow {

/// What the conductance of a throat and the forces on its grains follow from.
enum class Conductance {
    Bounded, ///< bounded drag, and momentum exchanged between throats: for grains of different sizes
    Yade,    ///< the hydraulic radius of each throat by itself, as in Yade 2023.02a
};

struct Fluid {
    double density = 1000;   ///< [kg/m3]
    double viscosity = 1e-3; ///< [Pa s]
    Conductance conductance = Conductance::Bounded;
    std::optional<double> bulk_modulus; ///< nothing: incompressible; of undrained tests, no flow depends on it [Pa]
};

/// What solves the flow.
enum class Solver {
    Network,  ///< of pores and throats
    Resolved, ///< on a grid between the grains themselves
    Auto,     ///< resolved where the network is known to fail
};

/// "network", "resolved", "auto".
constexpr std::string_view name_of(Solver solver) {
    return solver == Solver::Network ? "network" : solver == Solver::Resolved ? "resolved" : "auto";
}

/// Boxes of a resolved flow across the Sauter diameter where nobody says.
inline constexpr std::int64_t usual_boxes_across = 12;

struct SolverChoice {
    Solver solver = Solver::Network;
    std::optional<std::int64_t> resolve = {}; ///< boxes across the Sauter diameter; of the network: that flow as well
    double resolve_tolerance = 1e-4;          ///< of the resolved flow, see stokes::ResolvedSpec [-]
};

/// Whether the flow between the grains is requested, whatever the network's is worth.
constexpr bool resolves(const SolverChoice& how) {
    return how.solver == Solver::Resolved || (how.solver == Solver::Network && how.resolve);
}

/// `do = "flow"`: steady seepage through the frozen packing.
struct FlowSpec {
    double gradient = 0;        ///< hydraulic gradient i [-]
    Vec3 direction = {0, 0, 1}; ///< where the water goes: grad p = -i rho_w g direction
    bool tensor = false;        ///< solve three directions and report the permeability tensor
    SolverChoice how = {};      ///< for callers that have more than the network to choose from
};

} // namespace suffuse::flow
