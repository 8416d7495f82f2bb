#include "suffuse/erosion/weighed_probe.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/stokes/water.hpp"

#include <cmath>
#include <utility>

namespace suffuse::erosion {

namespace {

SolveFlow flow_along(const Vec3& direction, const ProbeSpec& probe, const Surroundings& around) {
    flow::SolverChoice how = probe.flow;
    if (flow::resolves(how)) {
        how.solver = flow::Solver::Resolved; // one flow gives the forces
    }
    return [how, direction, &around](const dem::World& copy) {
        const stokes::Water water = stokes::solve_water(
            copy.cell, copy.grains.position, copy.grains.radius, copy.grains.fine, {1, direction}, around.fluid, how,
            around.pulse
        );
        return UnitSeepage{water.grain_force(), water.source, water.permeability()};
    };
}

MobilitySetting setting_of(const DetachStageSpec& spec, const Surroundings& around) {
    return {
        .gravity = *spec.probe.gravity,
        .fluid = around.fluid,
        .direction = spec.direction,
        .gradients = spec.gradients,
        .motion = spec.probe.weighed,
        .specified_gradient = spec.specified_gradient};
}

/// Rows in the order in which the flow is solved and fines are named.
dem::World sorted(dem::World world) {
    dem::sort_along_curve(world);
    return world;
}

} // namespace

MobilityResult weigh_fines(const dem::World& world, const DetachStageSpec& spec, const Surroundings& around) {
    return find_mobility(world, setting_of(spec, around), flow_along(spec.direction, spec.probe, around), around.pulse);
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

MobilityRamp begin_detach(const dem::World& world, const DetachStageSpec& spec, const Surroundings& around) {
    return begin_ramp(
        sorted(world), setting_of(spec, around), flow_along(spec.direction, spec.probe, around), around.pulse
    );
}

void climb(MobilityRamp& ramp, const DetachStageSpec& spec, const Surroundings& around, const WatchRamp& watch) {
    climb(ramp, setting_of(spec, around), flow_along(spec.direction, spec.probe, around), around.pulse, watch);
}

MobilityResult detached(const MobilityRamp& ramp, const dem::World& world, const DetachStageSpec& spec) {
    MobilityResult mobility = ramp.result;
    const dem::World rows = sorted(world);
    try {
        mark_leaving(rows, measure_coarse_skeleton(rows, spec.direction, false), ConstrictionSize::Mean, mobility);
    } catch (const GeometryError&) {
        // too few coarse grains for constrictions: no share that leaves
    }
    return mobility;
}

} // namespace suffuse::erosion
