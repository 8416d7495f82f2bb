#pragma once
// Steady slow flow between the grains themselves, without a pore network: Stokes' equations on a staggered grid, with
// forces in the grains that make the water stand still there. Velocities are linear in those forces (`Response`), which
// gives symmetric equations for them: conjugate gradients. What a grain's forces add up to is the water's force on it.
// Two grids: errors of second order cancel.

#include "suffuse/base/pulse.hpp"
#include "suffuse/cell/cell.hpp"
#include "suffuse/flow/fluid.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::stokes {

struct ResolvedSpec {
    double boxes_across = 12; ///< of the finer grid, across the Sauter diameter of the grains
    double tolerance = 1e-4;  ///< on ResolvedFlow::residual [-]
    int iteration_limit = 2000;
};

/// Values are extrapolated from two grids; what describes the grid is that of the finer one.
struct ResolvedFlow {
    Vec3 pressure_gradient;        ///< mean: -i rho g direction [Pa/m]
    Vec3 mean_velocity;            ///< superficial [m/s]
    double permeability = 0;       ///< along the direction, also known at i = 0 [m2]
    std::optional<Mat3> tensor;    ///< permeability tensor, if requested [m2]
    std::vector<Vec3> grain_force; ///< of the fluid on each grain, without buoyancy; rows as given [N]
    Vec3 force_sum;                ///< over all grains: -V grad p [N]

    double finer_permeability = 0; ///< before extrapolation [m2]
    std::array<std::size_t, 3> boxes{};
    double spacing = 0;         ///< of the grid [m]
    double across_smallest = 0; ///< spacings across the smallest grain: below some 4 its force is a rough one
    int iterations = 0;         ///< largest of all directions
    double residual = 0;        ///< estimated error of the permeability of a grid; forces are off by its root [-]
    double seconds = 0;
};

/// The flow through the grains at `position` with `radius` [m], one row a grain. Takes about 150 bytes a box.
/// @throws CaseError for a fluid, direction or resolution that cannot be; GeometryError for a sheared cell, too many or
/// too few boxes, grains that are none or leave the water no way; SolverError where the tolerance is not reached.
ResolvedFlow resolve_flow(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius, const flow::FlowSpec& spec,
    const flow::Fluid& fluid, const ResolvedSpec& resolved = {}, const Pulse& pulse = {}
);

} // namespace suffuse::stokes
