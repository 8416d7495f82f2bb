#include "suffuse/stokes/resolved_flow.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/flow/reynolds.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/stokes/held_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::stokes {
namespace {

constexpr double coarser = 1.4; // spacing of the other grid over that of the finer

void check_grains(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius) {
    if (radius.empty()) {
        throw CaseError("resolved flow: there are no grains; water without grains has no permeability");
    }
    const Mat3 inverse_h = inverse(h);
    for (std::size_t g = 0; g < radius.size(); ++g) {
        const Vec3& x = position[g];
        if (!cell::has_period(inverse_h, x) || !std::isfinite(radius[g]) || !(radius[g] > 0)) {
            throw GeometryError(fmt::format(
                "resolved flow: the grain in row {} has position ({}, {}, {}) m and radius {} m; a place within {} "
                "periods of the cell and a radius above 0 are expected",
                g, x.x, x.y, x.z, radius[g], cell::largest_period
            ));
        }
    }
}

double finer_spacing(std::span<const double> radius, const ResolvedSpec& spec) {
    if (!(spec.boxes_across >= 4) || !std::isfinite(spec.boxes_across)) {
        throw CaseError(fmt::format(
            "resolved flow: {} boxes across the Sauter diameter; at least 4 are expected, 12 is usual",
            spec.boxes_across
        ));
    }
    return flow::sauter_diameter(radius) / spec.boxes_across;
}

/// Two grids that are one along an axis show nothing of its error.
void check_grids(const Grid& fine, const Grid& coarse) {
    for (std::size_t a = 0; a < 3; ++a) {
        if (fine.boxes[a] == coarse.boxes[a]) {
            throw GeometryError(fmt::format(
                "resolved flow: the cell is {} boxes wide along {}, too few for the second, coarser grid; use more "
                "boxes across a diameter, or a wider cell",
                fine.boxes[a], "xyz"[a]
            ));
        }
    }
}

/// Under unit driving forces along each of `directions`.
std::vector<UnitFlow> solve_all(
    const Grid& grid, std::span<const Vec3> position, std::span<const double> radius, std::span<const Vec3> directions,
    const ResolvedSpec& spec, const Pulse& pulse
) {
    HeldForces held(grid, position, radius);
    return held.solve(directions, {spec.tolerance, spec.iteration_limit}, pulse);
}

/// Of errors in proportion to the spacing squared nothing is left.
UnitFlow extrapolated(const UnitFlow& fine, const UnitFlow& coarse, double ratio) {
    const double weight = 1 / (ratio * ratio - 1);
    const auto beyond = [&](const Vec3& near, const Vec3& away) { return near + weight * (near - away); };
    UnitFlow flow = fine;
    flow.velocity = beyond(fine.velocity, coarse.velocity);
    for (std::size_t g = 0; g < flow.force.size(); ++g) {
        flow.force[g] = beyond(fine.force[g], coarse.force[g]);
    }
    flow.iterations = std::max(fine.iterations, coarse.iterations);
    flow.residual = std::max(fine.residual, coarse.residual);
    return flow;
}

double spacing_of(const Grid& grid) {
    return std::cbrt(grid.spacing.x * grid.spacing.y * grid.spacing.z);
}

} // namespace

ResolvedFlow resolve_flow(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius, const flow::FlowSpec& spec,
    const flow::Fluid& fluid, const ResolvedSpec& resolved, const Pulse& pulse
) {
    flow::check(spec, fluid);
    check_grains(cell.h, position, radius);
    const Stopwatch watch;
    const double spacing = finer_spacing(radius, resolved);
    const Vec3 direction = spec.direction / norm(spec.direction);
    std::vector<Vec3> directions{direction};
    if (spec.tensor) {
        directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    }
    const Grid fine = grid_over(cell.h, spacing), coarse = grid_over(cell.h, coarser * spacing);
    check_grids(fine, coarse);
    const std::vector<UnitFlow> on_fine = solve_all(fine, position, radius, directions, resolved, pulse);
    const std::vector<UnitFlow> on_coarse = solve_all(coarse, position, radius, directions, resolved, pulse);

    ResolvedFlow result;
    const double drive = fluid.density * gravity * spec.gradient; // [Pa/m]
    result.pressure_gradient = -drive * direction;
    result.boxes = fine.boxes;
    result.spacing = spacing_of(fine);
    result.across_smallest = 2 * *std::min_element(radius.begin(), radius.end()) / result.spacing;
    result.grain_force.assign(radius.size(), {});
    if (spec.tensor) {
        result.tensor.emplace();
    }
    Vec3 velocity, finer_velocity; // of unit drive and viscosity
    for (std::size_t b = 0; b < directions.size(); ++b) {
        const UnitFlow flow = extrapolated(on_fine[b], on_coarse[b], spacing_of(coarse) / spacing_of(fine));
        const double share = dot(direction, directions[b]);
        velocity += share * flow.velocity;
        finer_velocity += share * on_fine[b].velocity;
        for (std::size_t g = 0; g < radius.size(); ++g) {
            result.grain_force[g] += drive * share * flow.force[g];
        }
        for (int a = 0; result.tensor && a < 3; ++a) {
            (*result.tensor)(a, static_cast<int>(b)) = flow.velocity[a];
        }
        result.iterations = std::max(result.iterations, flow.iterations);
        result.residual = std::max(result.residual, flow.residual);
    }
    for (const Vec3& force : result.grain_force) {
        result.force_sum += force;
    }
    result.permeability = dot(velocity, direction);
    result.finer_permeability = dot(finer_velocity, direction);
    result.mean_velocity = (drive / fluid.viscosity) * velocity;
    result.seconds = watch.seconds();
    return result;
}

} // namespace suffuse::stokes
