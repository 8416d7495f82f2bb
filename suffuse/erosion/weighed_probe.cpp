#include "suffuse/erosion/weighed_probe.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/stokes/water.hpp"

#include <cmath>
#include <utility>

namespace suffuse::erosion {

MobilityResult weigh_fines(
    const dem::World& world, std::vector<double> gradients, std::optional<double> specified, const Vec3& direction,
    const ProbeSpec& probe, const Surroundings& around, const WatchRamp& watch
) {
    flow::SolverChoice how = probe.flow;
    if (flow::resolves(how)) {
        how.solver = flow::Solver::Resolved; // one flow gives the forces
    }
    const SolveFlow solve = [&](const dem::World& copy) {
        const stokes::Water water = stokes::solve_water(
            copy.cell, copy.grains.position, copy.grains.radius, copy.grains.fine, {1, direction}, around.fluid, how,
            around.pulse
        );
        return UnitSeepage{water.grain_force(), water.source, water.permeability()};
    };
    return find_mobility(
        world,
        {.gravity = *probe.gravity,
         .fluid = around.fluid,
         .direction = direction,
         .gradients = std::move(gradients),
         .motion = probe.weighed,
         .specified_gradient = specified},
        solve, around.pulse, watch
    );
}

void mark_leaving(
    const dem::World& world, const CoarseSkeleton& skeleton, ConstrictionSize size, MobilityResult& mobility
) {
    if (size == ConstrictionSize::FlowPath) {
        return;
    }
    std::vector<std::uint8_t> let_through;
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            let_through.push_back(passes(skeleton, size, g, 2 * world.grains.radius[g]) ? 1 : 0);
        }
    }
    mark_leaving(mobility, let_through);
}

std::vector<std::uint32_t> mobile_rows(const dem::World& world, const MobilityResult& mobility) {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t g = 0, k = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] == 0) {
            continue;
        }
        if (!std::isnan(mobility.mobile_gradient[k])) {
            rows.push_back(g);
        }
        ++k;
    }
    return rows;
}

MobilityResult probe_mobility(
    const dem::World& world, const DetachStageSpec& spec, const Surroundings& around, const WatchRamp& watch
) {
    dem::World sorted = world;
    dem::sort_along_curve(sorted);
    MobilityResult mobility =
        weigh_fines(sorted, spec.gradients, spec.specified_gradient, spec.direction, spec.probe, around, watch);
    try {
        mark_leaving(sorted, measure_coarse_skeleton(sorted, spec.direction, false), ConstrictionSize::Mean, mobility);
    } catch (const GeometryError&) {
        // too few coarse grains for constrictions: no share that leaves
    }
    return mobility;
}

} // namespace suffuse::erosion
