// Seepage through a world or any packing given as arrays.

#include "suffuse/stokes/water.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/flow/pore_velocity.hpp"
#include "suffuse/flow/reynolds.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/pores/constrictions.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/key_doc.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/packing.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/warn_caller.hpp"
#include "python/bindings/work.hpp"

namespace suffuse::python {
namespace {

using flow::Seepage;

/// A flow, what it was solved of and in which packing. The network is next to it, for callers that keep it alone. Where
/// the flow is resolved, what it does as a whole and to grains is of that, and pressures and fluxes of the network.
struct SolvedSeepage : Seepage {
    flow::FlowSpec spec;
    flow::Fluid fluid;
    flow::FlowSource source;
    std::shared_ptr<PackedNetwork> packed;
};

using Water = std::shared_ptr<SolvedSeepage>;

Water solve(Packing packing, const flow::FlowSpec& spec, const flow::Fluid& fluid) {
    const Computing computing;
    const cell::Cell cell{packing.h, {}};
    if (packing.fine.empty()) {
        packing.fine.resize(packing.radius.size());
    }
    stokes::Water water = stokes::solve_water(
        cell, packing.position, packing.radius, packing.fine, spec, fluid, spec.how, look_at_signals()
    );
    Seepage seepage = std::move(water.network);
    if (water.is_resolved()) {
        seepage.permeability = water.resolved->permeability;
        seepage.tensor = water.resolved->tensor;
        seepage.mean_velocity = water.resolved->mean_velocity;
        seepage.grain_force = std::move(water.resolved->grain_force);
        seepage.force_sum = water.resolved->force_sum;
    }
    auto packed = std::make_shared<PackedNetwork>(PackedNetwork{std::move(seepage.network), std::move(packing)});
    return std::make_shared<SolvedSeepage>(SolvedSeepage{
        std::move(seepage), spec, fluid, water.source, std::move(packed)});
}

double reynolds_number(const SolvedSeepage& water) {
    const double size = flow::sauter_diameter(water.packed->packing.radius);
    return flow::reynolds_number(water.permeability, water.spec.gradient, size, water.fluid);
}

double porosity(const SolvedSeepage& water) {
    const PackedNetwork& net = *water.packed;
    double voids = 0;
    for (const double part : net.pores.void_volume) {
        voids += part;
    }
    return voids / std::abs(determinant(net.h));
}

/// At the line that called the wrapper of `seep`.
void warn_of_flow(const std::string& words) {
    warn_caller(words.empty() ? "" : "flow: " + words, 3);
}

Water seep(
    const PackingOrCell& first, const NumbersOrNone& position, const NumbersOrNone& radius, const Quantity& gradient,
    const Direction& direction, flow::Fluid fluid, bool tensor, const std::optional<std::string>& conductance,
    const std::string& solver, std::optional<std::int64_t> resolve, double resolve_tolerance
) {
    const std::string key = "stage.flow";
    flow::FlowSpec spec{quantity_of(gradient, dimension::none, "gradient"), direction_of(direction), tensor};
    spec.how.solver = word_of(solver, casefile::names::solver, "solver");
    if (resolve) {
        spec.how.resolve = count_of(key_of(key, "resolve"), *resolve, "resolve");
        if (spec.how.solver == flow::Solver::Network) {
            throw CaseError("seep: `resolve` is for solver=\"resolved\" or \"auto\"; add it, or leave `resolve` out");
        }
    }
    spec.how.resolve_tolerance =
        value_of(key_of(key, "resolve_tolerance"), py::float_(resolve_tolerance), "resolve_tolerance");
    if (conductance) {
        fluid.conductance = word_of(*conductance, casefile::names::conductance, "conductance");
    }
    Water water = solve(packing_of(first, position, radius), spec, fluid);
    warn_of_flow(flow::words_of(water->source, "of the packing"));
    warn_of_flow(flow::words_of(water->closed_voids, [](std::uint32_t g) { return fmt::format("in row {}", g); }));
    warn_of_flow(flow::words_of_inertia("in the packing", spec.gradient, reynolds_number(*water), porosity(*water)));
    return water;
}

/// For another process: what it is solved from.
py::tuple take_water_apart(const SolvedSeepage& water) {
    const flow::SolverChoice& how = water.spec.how;
    return py::make_tuple(
        to_tuple(water.packed->packing), water.spec.gradient, to_array(water.spec.direction), water.spec.tensor,
        water.fluid, std::string(name_of(how.solver)), how.resolve, how.resolve_tolerance
    );
}

Water put_water_together(const py::tuple& state) {
    const flow::FlowSpec spec{
        state[1].cast<double>(),
        vector_of(state[2], dimension::none, "direction"),
        state[3].cast<bool>(),
        {word_of(state[5].cast<std::string>(), casefile::names::solver, "solver"),
         state[6].cast<std::optional<std::int64_t>>(), state[7].cast<double>()}};
    return solve(from_tuple(state[0].cast<py::tuple>()), spec, state[4].cast<flow::Fluid>());
}

std::vector<Vec3> pore_velocities_of(const SolvedSeepage& water) {
    const Packing& packing = water.packed->packing;
    return flow::pore_velocities(*water.packed, packing.position, packing.radius, water.field.flux);
}

void bind_seepage(py::module_& m) {
    py::class_<SolvedSeepage, Water> type(
        m, "Seepage",
        "Steady slow flow through a frozen packing, and what it does to the grains. It travels to another process as "
        "what it was solved from, and is solved again there, to the same bits."
    );
    type.def(py::pickle(&take_water_apart, &put_water_together));
    type.def("__repr__", [](const SolvedSeepage& water) {
        return fmt::format(
            "<suffuse.Seepage: permeability {:.4g} m2, superficial velocity {:.3g} m/s, Reynolds number {:.2g}>",
            water.permeability, norm(water.mean_velocity), reynolds_number(water)
        );
    });
    type.def_property_readonly(
        "network", [](const SolvedSeepage& water) { return water.packed; },
        "The pore network that the water flows through."
    );
    type.def_property_readonly(
        "gradient", [](const SolvedSeepage& water) { return water.spec.gradient; }, "Hydraulic gradient [-]."
    );
    type.def_property_readonly(
        "fluid", [](const SolvedSeepage& water) { return water.fluid; }, "A copy of the pore fluid."
    );
    type.def_property_readonly(
        "solver", [](const SolvedSeepage& water) { return std::string(name_of(water.source.solver)); },
        "What permeability, tensor, mean velocity and forces are of: \"network\" or \"resolved\". Pressures and fluxes "
        "are "
        "of the network."
    );
    type.def_property_readonly(
        "known_error", [](const SolvedSeepage& water) -> Typed<"dict[str, float | None]"> {
            const flow::KnownError& error = water.source.known_error;
            py::dict known;
            known["permeability"] = error.permeability;
            known["force_sum"] = error.force_sum;
            known["force"] = error.force;
            return known;
        },
        "Largest relative errors seen of such a flow, see validation/size_ratio.md: of the permeability, of the sum of "
        "the forces on the fines, of single forces (root mean square); None where no bound is known."
    );
    type.def_property_readonly(
        "raised_by_fines", [](const SolvedSeepage& water) { return water.source.raised_by_fines; },
        "The network's permeability over that of its coarse grains alone; None where there are not both kinds of "
        "grains. "
        "Grains can only lower it: above 1 `permeability` is the coarse grains' own, except by Yade's law."
    );
    type.def_property_readonly(
        "reynolds_number", &reynolds_number,
        "Of the superficial velocity and the diameter of equal spheres of as much surface, density x velocity x "
        "diameter / viscosity, as in stage.json [-]. The flow is solved without inertia: well below 1 that is right; "
        "see flux_left_by_inertia."
    );
    type.def_property_readonly(
        "flux_left_by_inertia",
        [](const SolvedSeepage& water) { return flow::share_left_by_inertia(reynolds_number(water), porosity(water)); },
        "Share of the flux that would be left with inertia, by Ergun's resistance of packed spheres [-]; a run warns "
        "below 0.9."
    );
    add_column(type, "conductance", &Seepage::conductance, "throats: flux per difference of pressure [m3/(Pa s)].");
    add_column(type, "pressure", &Seepage::field, &flow::FlowField::pressure, "pores: excess pressure [Pa].");
    add_column(type, "flux", &Seepage::field, &flow::FlowField::flux, "throats: from side 0 to side 1 [m3/s].");
    add_column(
        type, "grain_force", &Seepage::grain_force, "grains x 3: of the fluid on each grain, without buoyancy [N]."
    );
    type.def_readonly("permeability", &Seepage::permeability, "Intrinsic, along the direction [m2].");
    type.def_property_readonly(
        "tensor", [](const SolvedSeepage& water) -> Typed<"numpy.ndarray | None"> {
            return water.tensor ? py::object(to_array(*water.tensor)) : py::object(py::none());
        },
        "3 x 3: permeability, if requested; else None [m2]."
    );
    type.def_property_readonly(
        "pressure_gradient", [](const SolvedSeepage& water) { return to_array(water.pressure_gradient); },
        "3: mean [Pa/m]."
    );
    type.def_property_readonly(
        "mean_velocity", [](const SolvedSeepage& water) { return to_array(water.mean_velocity); },
        "3: superficial [m/s]."
    );
    type.def_property_readonly(
        "pore_velocity",
        [](const SolvedSeepage& water) {
            const auto velocity = std::make_shared<std::vector<Vec3>>(pore_velocities_of(water));
            return look_at(*velocity, hold(velocity));
        },
        "pores x 3: mean velocity of the water in each pore, computed anew at each access [m/s]."
    );
    type.def_property_readonly(
        "tortuosity",
        [](const SolvedSeepage& water) { return flow::tortuosity(*water.packed, pore_velocities_of(water)); },
        "Mean speed of the water from pore to pore over that of its mean motion; not a number at rest [-]."
    );
    type.def_property_readonly(
        "force_sum", [](const SolvedSeepage& water) { return to_array(water.force_sum); }, "3: over all grains [N]."
    );
    type.def_readonly(
        "force_sum_error", &Seepage::force_sum_error, "|force_sum + V grad p| / |V grad p|: the balance of forces [-]."
    );
    type.def_property_readonly(
        "residual", [](const SolvedSeepage& water) { return water.field.residual; }, "Of the pressures, relative [-]."
    );
    const std::string doc = "Solves the flow through a World, or through cell, positions and radii [m].\n\ngradient: " +
                            key_doc(key_of("stage.flow", "gradient")) +
                            "\ndirection: " + key_doc(key_of("stage.flow", "direction")) +
                            "\ntensor: " + key_doc(key_of("stage.flow", "tensor")) +
                            "\nconductance: " + key_doc(key_of("fluid", "conductance")) + " None: the fluid's." +
                            "\nsolver: " + key_doc(key_of("stage.flow", "solver")) +
                            "\nresolve: boxes of the grid across the Sauter diameter; None: 12." +
                            "\nresolve_tolerance: " + key_doc(key_of("stage.flow", "resolve_tolerance"));
    m.def(
        "seep", &seep, py::arg("packing_or_cell"), py::arg("position") = py::none(), py::arg("radius") = py::none(),
        py::kw_only(), py::arg("gradient") = 0.0, py::arg("direction") = "z",
        py::arg_v("fluid", flow::Fluid{}, "Fluid()"), py::arg("tensor") = false, py::arg("conductance") = py::none(),
        py::arg("solver") = "network", py::arg("resolve") = py::none(), py::arg("resolve_tolerance") = 1e-4, doc.c_str()
    );
}

} // namespace

void bind_water(py::module_& m) {
    bind_seepage(m);
}

} // namespace suffuse::python
