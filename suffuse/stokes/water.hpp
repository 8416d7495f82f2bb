#pragma once
// The water of a packing by the pore network, and by the flow between the grains themselves where that is requested, or
// where the network is known to fail.

#include "suffuse/flow/known_error.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/stokes/resolved_flow.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::stokes {

struct Water {
    flow::Seepage network;
    std::optional<ResolvedFlow> resolved; ///< where it was solved
    flow::FlowSource source;              ///< of permeability() and grain_force()

    [[nodiscard]] bool is_resolved() const { return source.solver == flow::Solver::Resolved; }

    /// Along the direction [m2].
    [[nodiscard]] double permeability() const { return is_resolved() ? resolved->permeability : network.permeability; }

    /// On each grain, without buoyancy; rows as given [N].
    [[nodiscard]] const std::vector<Vec3>& grain_force() const {
        return is_resolved() ? resolved->grain_force : network.grain_force;
    }
};

/// Solves the network always: paths, fluxes and tortuosity are its own. With Solver::Network and `resolve` the resolved
/// flow stands next to it and is not the source; Solver::Auto takes the network's in a sheared cell.
/// @param fine 1 for a fine grain, a row a grain; where none is marked, sizes decide (flow::distinguish_fines)
/// @throws as flow::solve_seepage and resolve_flow
Water solve_water(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius,
    std::span<const std::uint8_t> fine, const flow::FlowSpec& spec, const flow::Fluid& fluid,
    const flow::SolverChoice& how, const Pulse& pulse = {}
);

} // namespace suffuse::stokes
