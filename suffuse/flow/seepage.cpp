#include "suffuse/flow/seepage.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/loop_meter.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/flow/bounded_drag.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/drag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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

void sum_forces(Seepage& s) {
    s.force_sum = {};
    for (const Vec3& force : s.grain_force) {
        s.force_sum += force;
    }
    s.force_sum_error = relative_force_error(s);
}

/// Hydraulic gradients beyond are refused: squares of what they drive would not be numbers.
constexpr double largest_gradient = 1e50, smallest_gradient = 1e-50;

/// Forces that add up no better than this are no forces.
constexpr double worst_force_sum = 1e-3;

ClosedVoids find_closed_voids(const pores::PoreNetwork& network) {
    const pores::VoidAccount voids = pores::account_voids(network);
    if (!(voids.all > 0)) {
        const auto [a, b, c, d] = voids.deepest;
        throw GeometryError(fmt::format(
            "flow: the grains overlap so far that no void is left to flow through: as pores count it, it is {:.3g} of "
            "the cell, most negative between the grains in rows {}, {}, {} and {}; let the grains settle first",
            voids.all / determinant(network.h), a, b, c, d
        ));
    }
    return {voids.negative / voids.all, voids.deepest};
}

/// Width of throats, the root of their void area, averaged over `what` they hold [m].
double mean_width(const pores::PoreNetwork& network, std::span<const double> what) {
    double all = 0, widths = 0;
    for (std::size_t t = 0; t < what.size(); ++t) {
        all += std::abs(what[t]), widths += std::abs(what[t]) * std::sqrt(network.throats.void_area[t]);
    }
    return all > 0 ? widths / all : 0;
}

/// A last look, whatever led to it.
void expect_numbers(const Seepage& s, std::span<const Vec3> position) {
    for (std::size_t g = 0; g < s.grain_force.size(); ++g) {
        if (!std::isfinite(norm2(s.grain_force[g]))) {
            throw GeometryError(fmt::format(
                "flow: the force on the grain in row {}, at ({}, {}, {}) m, is not a number; look for grains that "
                "overlap it, and at the fluid's viscosity and density",
                g, position[g].x, position[g].y, position[g].z
            ));
        }
    }
    const double numbers = s.permeability + norm2(s.mean_velocity) + s.field.residual + s.field.net_outflow;
    if (!std::isfinite(numbers) || !(s.force_sum_error <= worst_force_sum)) {
        throw GeometryError(fmt::format(
            "flow: permeability {} m2, and the forces on the grains are {} of the gradient's off their sum: no result; "
            "look for grains much smaller than the cell, and at the fluid's viscosity and density",
            s.permeability, s.force_sum_error
        ));
    }
}

} // namespace

void check(const FlowSpec& spec, const Fluid& fluid) {
    const double length = norm(squarable(spec.direction));
    if (!std::isfinite(length) || !(length > 0)) {
        throw CaseError(fmt::format(
            "flow: direction ({}, {}, {}) is not a direction; three finite numbers, not all zero, are expected",
            spec.direction.x, spec.direction.y, spec.direction.z
        ));
    }
    if (!std::isfinite(spec.gradient)) {
        throw CaseError("flow: the hydraulic gradient is not a finite number");
    }
    const double size = std::abs(spec.gradient);
    if (size > largest_gradient || (size > 0 && size < smallest_gradient)) {
        throw CaseError(fmt::format(
            "flow: the hydraulic gradient is {}; 0, or a size between {} and {}, is expected", spec.gradient,
            smallest_gradient, largest_gradient
        ));
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
    MeteredPhase phase("triangulation");
    pores::Triangulation triangulation = pores::triangulate(cell.h, position, radius);
    pores::expect_grains_apart(cell.h, position, radius);
    s.seconds.triangulate = watch.lap();
    phase.next("network");
    s.network = pores::build_network(std::move(triangulation), cell.h, position, radius);
    s.closed_voids = find_closed_voids(s.network);
    phase.next("conductance");
    std::optional<BoundedDrag> bounded;
    if (fluid.conductance == Conductance::Bounded) {
        bounded.emplace(s.network, position, radius);
    }
    s.network.throats.wetted = std::vector<std::array<double, 3>>();
    s.conductance = bounded ? bounded->conductances(fluid.viscosity) : conductances(s.network, fluid.viscosity);
    double width_of_water = 0;
    if (bounded) {
        const std::span<const double> water = bounded->water();
        s.overlap = bounded->covered_twice() / std::accumulate(water.begin(), water.end(), 0.0);
        width_of_water = mean_width(s.network, water);
        bounded->forget_water(); // the solution needs the room
    }
    s.seconds.conductance = watch.lap();

    const Vec3 along = squarable(spec.direction);
    const Vec3 unit = (-fluid.density * gravity / norm(along)) * along; // at i = 1
    phase.next("multigrid");
    std::optional<PressureSolver> solver(std::in_place, s.network, s.conductance);
    s.seconds.set_up = watch.lap();
    phase.next("solution");
    s.field = solver->solve(unit);
    s.mean_velocity = mean_velocity(s.network, s.field.flux);
    s.permeability = -fluid.viscosity * dot(s.mean_velocity, unit) / norm2(unit);
    if (spec.tensor) {
        s.tensor = permeability_tensor(*solver, s.network, fluid.viscosity);
    }
    solver.reset(); // forces need the room
    const double width_of_flow = bounded ? mean_width(s.network, s.field.flux) : 0;
    s.channeling = width_of_flow > 0 ? width_of_flow / width_of_water : 1;
    s.seconds.solve = watch.lap();
    phase.next("forces");
    s.pressure_gradient = unit;
    s.grain_force = bounded ? bounded->grain_forces(s.field.pressure, unit)
                            : grain_forces(s.network, s.field.pressure, unit, position, radius);
    sum_forces(s);
    expect_numbers(s, position);
    scale(s, spec.gradient);
    s.seconds.forces = watch.lap();
    return s;
}

ClosedVoids named_by_id(ClosedVoids closed, std::span<const std::uint32_t> id) {
    for (std::uint32_t& grain : closed.grain) {
        grain = id[grain];
    }
    return closed;
}

std::string words_of(const ClosedVoids& closed, const std::function<std::string(std::uint32_t)>& grain) {
    if (!(closed.share > many_closed_voids)) {
        return {};
    }
    return fmt::format(
        "grains overlap so far that the pore network counts negative voids, {:.2g} of all void, most between the "
        "grains {}, {}, {} and {}: there its throats mean nothing, and the permeability is not that of the packing; "
        "let the grains settle first",
        closed.share, grain(closed.grain[0]), grain(closed.grain[1]), grain(closed.grain[2]), grain(closed.grain[3])
    );
}

bool limit_to_coarse(Seepage& s, Conductance law, double coarse_permeability) {
    if (law != Conductance::Bounded || !(coarse_permeability > 0) || !(s.permeability > coarse_permeability)) {
        return false;
    }
    const double factor = s.permeability / coarse_permeability;
    for (std::vector<double>* column : {&s.conductance, &s.field.flux}) {
        for (double& each : *column) {
            each /= factor;
        }
    }
    s.field.net_outflow /= factor;
    s.mean_velocity *= 1 / factor;
    s.permeability /= factor;
    if (s.tensor) {
        *s.tensor = (1 / factor) * *s.tensor;
    }
    return true;
}

void scale(Seepage& s, double factor) {
    scale(s.field, factor);
    s.pressure_gradient *= factor;
    s.mean_velocity *= factor;
    for (Vec3& force : s.grain_force) {
        force *= factor;
    }
    sum_forces(s);
}

} // namespace suffuse::flow
