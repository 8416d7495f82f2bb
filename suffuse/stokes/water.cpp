#include "suffuse/stokes/water.hpp"

#include "suffuse/pores/constrictions.hpp"
#include "suffuse/stokes/grid.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::stokes {
namespace {

/// Share of what extrapolation from two grids moves that may still be missing (validation/resolved_flow.md).
constexpr double left_by_extrapolation = 0.5;

flow::KnownError error_of(const ResolvedFlow& flow) {
    const double moved = std::abs(flow.finer_permeability / flow.permeability - 1);
    return {left_by_extrapolation * moved, std::nullopt, std::nullopt};
}

} // namespace

Water solve_water(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius,
    std::span<const std::uint8_t> fine, const flow::FlowSpec& spec, const flow::Fluid& fluid,
    const flow::SolverChoice& how, const Pulse& pulse
) {
    Water water{.network = flow::solve_seepage(cell, position, radius, spec, fluid)};
    pores::measure_constrictions(water.network.network, position, radius);
    std::vector<std::uint8_t> marks;
    if (std::ranges::count(fine, std::uint8_t{0}) == std::ssize(fine)) {
        marks = flow::distinguish_fines(radius);
        fine = marks;
    }
    flow::Mixture mixture = flow::describe_mixture(radius, fine, std::abs(determinant(cell.h)));
    mixture.overlap = water.network.overlap;
    mixture.channeling = water.network.channeling;
    flow::FlowSource& source = water.source;
    if (const auto coarse = flow::coarse_permeability(cell, position, radius, fine, spec.direction, fluid)) {
        source.raised_by_fines = water.network.permeability / *coarse;
        source.is_limited = flow::limit_to_coarse(water.network, fluid.conductance, *coarse);
    }
    source.doubt = flow::doubt_network(mixture, source.raised_by_fines);
    source.known_error = flow::known_error(fluid.conductance, mixture);

    const bool is_requested = how.solver == flow::Solver::Resolved || how.resolve;
    const bool is_better = source.doubt != flow::Doubt::None && is_right_angled(cell.h);
    if (how.solver == flow::Solver::Auto ? is_better : is_requested) {
        water.resolved = resolve_flow(
            cell, position, radius, spec, fluid,
            {.boxes_across = static_cast<double>(how.resolve.value_or(flow::usual_boxes_across)),
             .tolerance = how.resolve_tolerance},
            pulse
        );
    }
    if (water.resolved && how.solver != flow::Solver::Network) {
        source.solver = flow::Solver::Resolved;
        source.known_error = error_of(*water.resolved);
    }
    return water;
}

} // namespace suffuse::stokes
