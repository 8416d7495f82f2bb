#include "suffuse/flow/seepage.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/flow/bounded_drag.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/drag.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace suffuse::flow {
namespace {

/// Column b is the mean velocity under a unit pressure gradient along b, times -viscosity.
Mat3 permeability_tensor(const PressureSolver& solver, const pores::PoreNetwork& network, double viscosity) {
    Mat3 tensor;
    for (int b = 0; b < 3; ++b) {
        Vec3 gradient;
        gradient[b] = 1;
        const Vec3 velocity = mean_velocity(network, solver.solve(gradient).flux);
        for (int a = 0; a < 3; ++a) {
            tensor(a, b) = -viscosity * velocity[a];
        }
    }
    return tensor;
}

double relative_force_error(const Seepage& s) {
    const Vec3 expected = -determinant(s.network.h) * s.pressure_gradient;
    return norm(expected) > 0 ? norm(s.force_sum - expected) / norm(expected) : 0;
}

} // namespace

void check(const FlowSpec& spec, const Fluid& fluid) {
    const double length = norm(spec.direction);
    if (!std::isfinite(length) || !(length > 0)) {
        throw CaseError(fmt::format(
            "flow: direction ({}, {}, {}) is not a direction; three finite numbers, not all zero, are expected",
            spec.direction.x, spec.direction.y, spec.direction.z
        ));
    }
    if (!std::isfinite(spec.gradient)) {
        throw CaseError("flow: the hydraulic gradient is not a finite number");
    }
    if (!(fluid.viscosity > 0) || !(fluid.density > 0) || !std::isfinite(fluid.viscosity * fluid.density)) {
        throw CaseError(fmt::format(
            "flow: fluid of viscosity {} Pa s and density {} kg/m3; both must be positive", fluid.viscosity,
            fluid.density
        ));
    }
}

Seepage solve_seepage(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius, const FlowSpec& spec,
    const Fluid& fluid
) {
    check(spec, fluid);
    Seepage s;
    Stopwatch watch;
    pores::Triangulation triangulation = pores::triangulate(cell.h, position, radius);
    s.seconds.triangulate = watch.lap();
    s.network = pores::build_network(std::move(triangulation), cell.h, position, radius);
    std::optional<BoundedDrag> bounded;
    if (fluid.conductance == Conductance::Bounded) {
        bounded.emplace(s.network, position, radius);
    }
    s.conductance = bounded ? bounded->conductances(fluid.viscosity) : conductances(s.network, fluid.viscosity);
    s.seconds.conductance = watch.lap();

    const Vec3 unit = (-fluid.density * gravity / norm(spec.direction)) * spec.direction; // at i = 1
    std::optional<PressureSolver> solver(std::in_place, s.network, s.conductance);
    s.field = solver->solve(unit);
    s.mean_velocity = mean_velocity(s.network, s.field.flux);
    s.permeability = -fluid.viscosity * dot(s.mean_velocity, unit) / norm2(unit);
    if (spec.tensor) {
        s.tensor = permeability_tensor(*solver, s.network, fluid.viscosity);
    }
    solver.reset(); // forces need the room
    s.seconds.solve = watch.lap();
    s.pressure_gradient = unit;
    s.grain_force = bounded ? bounded->grain_forces(s.field.pressure, unit)
                            : grain_forces(s.network, s.field.pressure, unit, radius.size());
    scale(s, spec.gradient);
    s.seconds.forces = watch.lap();
    return s;
}

void scale(Seepage& s, double factor) {
    scale(s.field, factor);
    s.pressure_gradient *= factor;
    s.mean_velocity *= factor;
    s.force_sum = {};
    for (Vec3& force : s.grain_force) {
        force *= factor;
        s.force_sum += force;
    }
    s.force_sum_error = relative_force_error(s);
}

} // namespace suffuse::flow
