#pragma once
// Steady seepage through the frozen packing, from grains to fluid forces and permeability: triangulate, measure, solve,
// act.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/flow/pressure.hpp"
#include "suffuse/pores/network.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace suffuse::flow {

/// Wall seconds of each part.
struct SeepageSeconds {
    double triangulate = 0, conductance = 0, forces = 0;
    double set_up = 0, solve = 0; ///< of the multigrid, and the solution by it
};

/// Where grains overlap so far that the network counts a negative void between them (pores::VoidAccount).
struct ClosedVoids {
    double share = 0;                        ///< of the whole void [-]
    std::array<std::uint32_t, 4> grain = {}; ///< rows of those around the most negative one
};

/// The same with ids of grains in place of their rows. @param id a number a row
ClosedVoids named_by_id(ClosedVoids closed, std::span<const std::uint32_t> id);

/// Beyond this share a warning names closed voids: far above rounding, and above packings under stress (validation).
inline constexpr double many_closed_voids = 1e-3;

/// The warning of a flow with more closed voids than that, grains named as `grains` names their rows; else empty.
std::string words_of(const ClosedVoids& closed, const std::function<std::string(std::uint32_t)>& grain);

struct Seepage {
    pores::PoreNetwork network;
    std::vector<double> conductance; ///< per throat [m3/(Pa s)]
    Vec3 pressure_gradient;          ///< mean: -i rho g direction [Pa/m]
    FlowField field;
    std::vector<Vec3> grain_force; ///< of the fluid on each grain, without buoyancy; rows as given [N]
    double permeability = 0;       ///< along the direction, from the unit gradient: also known at i = 0 [m2]
    std::optional<Mat3> tensor;    ///< permeability tensor, if requested [m2]
    Vec3 mean_velocity;            ///< superficial [m/s]
    Vec3 force_sum;                ///< over all grains [N]
    ClosedVoids closed_voids;
    double overlap = 0; ///< share of the void that overlapping grains cover twice; by bounded drag [-]
    double channeling =
        1; ///< width of throats, averaged over the flow, over that averaged over the water; the same [-]
    double force_sum_error = 0; ///< |force_sum + V grad p| / |V grad p|, 0 where there is no gradient [-]
    SeepageSeconds seconds;
};

/// @throws CaseError for a fluid, gradient or direction that cannot be.
void check(const FlowSpec& spec, const Fluid& fluid);

/// Solves the flow through the grains at `position` with `radius` [m], one row a grain.
/// @throws GeometryError, also where grains overlap over all the void; SolverError; CaseError for a fluid or direction
/// that cannot be. No result has a number that is none.
Seepage solve_seepage(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius, const FlowSpec& spec,
    const Fluid& fluid
);

/// Grains among the coarse ones can only lower the permeability. By bounded drag divides all conductances, and with
/// them fluxes, velocity and permeability, where it is above that of the coarse grains alone [m2], if that is above 0;
/// pressures and forces do not depend on a common factor. @return whether it was
bool limit_to_coarse(Seepage& seepage, Conductance law, double coarse_permeability);

/// Multiplies the pressure gradient, and with it everything that is linear in it: one solution serves all gradients.
void scale(Seepage& seepage, double factor);

} // namespace suffuse::flow
