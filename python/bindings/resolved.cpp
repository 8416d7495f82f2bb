// The flow between the grains themselves, of a world or any packing given as arrays.

#include "suffuse/base/units.hpp"
#include "suffuse/stokes/resolved_flow.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/key_doc.hpp"
#include "python/bindings/packing.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/work.hpp"

namespace suffuse::python {
namespace {

using stokes::ResolvedFlow;

std::shared_ptr<ResolvedFlow> resolve_flow(
    const PackingOrCell& first, const NumbersOrNone& position, const NumbersOrNone& radius, const Quantity& gradient,
    const Direction& direction, const flow::Fluid& fluid, bool tensor, double boxes_across, double tolerance
) {
    const Packing packing = packing_of(first, position, radius);
    const flow::FlowSpec spec{quantity_of(gradient, dimension::none, "gradient"), direction_of(direction), tensor};
    const Computing computing;
    return std::make_shared<ResolvedFlow>(stokes::resolve_flow(
        {packing.h, {}}, packing.position, packing.radius, spec, fluid,
        {.boxes_across = boxes_across, .tolerance = tolerance}, look_at_signals()
    ));
}

template <class Column>
void add_vector(
    py::class_<ResolvedFlow, std::shared_ptr<ResolvedFlow>>& type, const char* name, Column ResolvedFlow::*column,
    const char* doc
) {
    type.def_property_readonly(
        name, [=](const ResolvedFlow& flow) { return to_array(flow.*column); }, doc
    );
}

/// For another process: the numbers themselves, for solving them again would take minutes.
py::tuple take_apart(const ResolvedFlow& flow) {
    return py::make_tuple(
        to_array(flow.pressure_gradient), to_array(flow.mean_velocity), flow.permeability,
        flow.tensor ? py::object(to_array(*flow.tensor)) : py::object(py::none()), to_array(flow.grain_force),
        to_array(flow.force_sum), flow.finer_permeability, flow.boxes, flow.spacing, flow.across_smallest,
        flow.iterations, flow.residual, flow.seconds
    );
}

std::shared_ptr<ResolvedFlow> put_together(const py::tuple& state) {
    const auto vector = [&](int at) { return vector_of(state[at], dimension::none, "pickled flow"); };
    auto flow = std::make_shared<ResolvedFlow>();
    flow->pressure_gradient = vector(0);
    flow->mean_velocity = vector(1);
    flow->permeability = state[2].cast<double>();
    if (!state[3].is_none()) {
        flow->tensor = matrix_of(state[3], dimension::none, "pickled flow");
    }
    flow->grain_force = vectors_of(state[4], "pickled flow");
    flow->force_sum = vector(5);
    flow->finer_permeability = state[6].cast<double>();
    flow->boxes = state[7].cast<std::array<std::size_t, 3>>();
    flow->spacing = state[8].cast<double>();
    flow->across_smallest = state[9].cast<double>();
    flow->iterations = state[10].cast<int>();
    flow->residual = state[11].cast<double>();
    flow->seconds = state[12].cast<double>();
    return flow;
}

} // namespace

void bind_resolved(py::module_& m) {
    py::class_<ResolvedFlow, std::shared_ptr<ResolvedFlow>> type(
        m, "ResolvedFlow",
        "Steady slow flow between the grains themselves, extrapolated from two grids, and what it does to the grains."
    );
    type.def(py::pickle(&take_apart, &put_together));
    type.def("__repr__", [](const ResolvedFlow& flow) {
        return fmt::format(
            "<suffuse.ResolvedFlow: permeability {:.4g} m2, {} x {} x {} boxes of {:.3g} m>", flow.permeability,
            flow.boxes[0], flow.boxes[1], flow.boxes[2], flow.spacing
        );
    });
    add_column(
        type, "grain_force", &ResolvedFlow::grain_force, "grains x 3: of the fluid on each grain, without buoyancy [N]."
    );
    type.def_readonly("permeability", &ResolvedFlow::permeability, "Intrinsic, along the direction [m2].");
    type.def_readonly(
        "finer_permeability", &ResolvedFlow::finer_permeability,
        "That of the finer grid; its distance from the extrapolated one indicates the error [m2]."
    );
    type.def_property_readonly(
        "tensor", [](const ResolvedFlow& flow) -> Typed<"numpy.ndarray | None"> {
            return flow.tensor ? py::object(to_array(*flow.tensor)) : py::object(py::none());
        },
        "3 x 3: permeability, if requested; else None [m2]."
    );
    add_vector(type, "pressure_gradient", &ResolvedFlow::pressure_gradient, "3: mean [Pa/m].");
    add_vector(type, "mean_velocity", &ResolvedFlow::mean_velocity, "3: superficial [m/s].");
    add_vector(type, "force_sum", &ResolvedFlow::force_sum, "3: over all grains [N].");
    type.def_property_readonly(
        "boxes", [](const ResolvedFlow& flow) { return py::make_tuple(flow.boxes[0], flow.boxes[1], flow.boxes[2]); },
        "Of the finer grid, along x, y, z."
    );
    type.def_readonly("spacing", &ResolvedFlow::spacing, "Of the finer grid [m].");
    type.def_readonly(
        "across_smallest", &ResolvedFlow::across_smallest,
        "Spacings across the smallest grain; below some 4 the force on it is a rough one [-]."
    );
    type.def_readonly("iterations", &ResolvedFlow::iterations, "Of the solver, the most of a direction.");
    type.def_readonly("residual", &ResolvedFlow::residual, "Speed left where the water stands still, relative [-].");
    type.def_readonly("seconds", &ResolvedFlow::seconds, "Wall time [s].");
    const std::string doc =
        "Solves the slow flow between the grains themselves on a grid, through a World, or through cell, positions and "
        "radii [m]; the cell has to be right-angled. The pore network of `seep` approximates, this converges. Seconds "
        "for hundreds of grains, minutes for ten thousand.\n\ngradient: " +
        key_doc(key_of("stage.flow", "gradient")) + "\ndirection: " + key_doc(key_of("stage.flow", "direction")) +
        "\ntensor: " + key_doc(key_of("stage.flow", "tensor")) +
        "\nboxes_across: boxes of the finer grid across the Sauter diameter of the grains, 4 at least.\n"
        "tolerance: of the flow, over itself.";
    m.def(
        "resolve_flow", &resolve_flow, py::arg("packing_or_cell"), py::arg("position") = py::none(),
        py::arg("radius") = py::none(), py::kw_only(), py::arg("gradient") = 0.0, py::arg("direction") = "z",
        py::arg_v("fluid", flow::Fluid{}, "Fluid()"), py::arg("tensor") = false, py::arg("boxes_across") = 12.0,
        py::arg("tolerance") = 1e-4, doc.c_str()
    );
}

} // namespace suffuse::python
