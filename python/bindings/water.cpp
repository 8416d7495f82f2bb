// Pore networks, constrictions and seepage, of a world or of any packing given as arrays.

#include "suffuse/flow/pore_velocity.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/pores/constrictions.hpp"
#include "suffuse/pores/widest_path.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_doc.hpp"
#include "python/bindings/views.hpp"
#include "python/bindings/world_handle.hpp"
#include <algorithm>

namespace suffuse::python {
namespace {

using flow::Seepage;
using pores::Constrictions;
using pores::PoreNetwork;

/// A packing as the caller gives it: a world, or cell, positions and radii.
struct Packing {
    Mat3 h;
    std::vector<Vec3> position;
    std::vector<double> radius;
};

Packing packing_of(const py::object& first, const py::object& position, const py::object& radius) {
    if (py::isinstance<WorldHandle>(first)) {
        const dem::World& world = first.cast<const WorldHandle&>().world();
        return {world.cell.h, world.grains.position, world.grains.radius};
    }
    if (position.is_none() || radius.is_none()) {
        throw CaseError("a packing is a World, or its cell, positions and radii");
    }
    Packing packing{cell_of(first), vectors_of(position, "position"), {}};
    packing.radius = numbers_of(radius, "radius", packing.position.size());
    return packing;
}

/// A flow, and the packing that it was solved in.
struct SolvedSeepage : Seepage {
    Packing packing;
};

/// A column of a table that lives inside `Owner`, or inside what it is derived from.
template <class Owner, class Base, class Table, class Column>
void add_column(
    py::class_<Owner, std::shared_ptr<Owner>>& type, const char* name, Table Base::*table, Column Table::*column,
    const char* doc
) {
    type.def_property_readonly(
        name, [=](const std::shared_ptr<Owner>& owner) { return look_at(((*owner).*table).*column, hold(owner)); }, doc
    );
}

template <class Owner, class Base, class Column>
void add_column(
    py::class_<Owner, std::shared_ptr<Owner>>& type, const char* name, Column Base::*column, const char* doc
) {
    type.def_property_readonly(
        name, [=](const std::shared_ptr<Owner>& owner) { return look_at((*owner).*column, hold(owner)); }, doc
    );
}

/// Images of an n x k table of grains or neighbors, as n x k x 3.
template <std::size_t N>
py::array images(const std::vector<std::array<cell::Image, N>>& column, const py::capsule& owner) {
    static_assert(sizeof(cell::Image) == 3 * sizeof(std::int16_t));
    py::array flat =
        look_at(column.empty() ? nullptr : &column.front().front().a, column.size(), 3 * N, sizeof(column[0]), owner);
    return py::array(flat.attr("reshape")(py::make_tuple(column.size(), N, 3)));
}

pores::VoidMerge merge_of(const std::string& word) {
    for (const pores::VoidMerge merge : pores::every_merge) {
        if (word == pores::name_of(merge)) {
            return merge;
        }
    }
    throw CaseError("constrictions: merge is \"none\", \"center\" or \"overlap\"; found \"" + word + "\"");
}

void bind_constrictions(py::module_& m) {
    py::class_<Constrictions, std::shared_ptr<Constrictions>> type(
        m, "Constrictions",
        "Circles inscribed in the facets of the weighted Delaunay triangulation that lie between voids."
    );
    type.def("__len__", [](const Constrictions& c) { return c.diameter.size(); });
    add_column(type, "diameter", &Constrictions::diameter, "constrictions: of the circle [m].");
    add_column(type, "center", &Constrictions::center, "constrictions x 3: of the circle [m].");
    type.def_readonly("mean", &Constrictions::mean, "Mean diameter by number of facets [m].");
    type.def_readonly("median", &Constrictions::median, "Half of the facets are smaller [m].");
    type.def_readonly("d35", &Constrictions::d35, "35 % of the facets are smaller [m].");
    m.def(
        "constrictions",
        [](const py::object& first, const py::object& position, const py::object& radius, const std::string& of,
           const std::string& merge) {
            const pores::VoidMerge way = merge_of(merge);
            Packing packing = packing_of(first, position, radius);
            if (of != "all" && of != "coarse") {
                throw CaseError("constrictions: of is \"all\" or \"coarse\"");
            }
            if (of == "coarse") {
                if (!py::isinstance<WorldHandle>(first)) {
                    throw CaseError("constrictions of the coarse grains need a World, which knows its fines");
                }
                const grains::Grains& grains = first.cast<const WorldHandle&>().world().grains;
                std::size_t kept = 0;
                for (std::size_t g = 0; g < grains.size(); ++g) {
                    if (grains.fine[g] == 0) {
                        packing.position[kept] = packing.position[g];
                        packing.radius[kept++] = packing.radius[g];
                    }
                }
                packing.position.resize(kept);
                packing.radius.resize(kept);
            }
            const py::gil_scoped_release released;
            return std::make_shared<Constrictions>(
                pores::find_constrictions(packing.h, packing.position, packing.radius, way)
            );
        },
        py::arg("packing_or_cell"), py::arg("position") = py::none(), py::arg("radius") = py::none(), py::kw_only(),
        py::arg("of") = "all", py::arg("merge") = "none",
        "Constrictions of all grains, or, of=\"coarse\", of the coarse skeleton of a World.\n\nmerge: which "
        "neighboring "
        "pores are one void, with no constriction between them: \"none\" (each facet counts), \"center\" (the center "
        "of "
        "the void sphere of one lies in that of the other), \"overlap\" (their void spheres overlap)."
    );
}

void bind_network(py::module_& m) {
    using pores::Pores;
    using pores::Throats;
    using Net = std::shared_ptr<PoreNetwork>;
    py::class_<PoreNetwork, Net> type(
        m, "PoreNetwork",
        "The pore network of a periodic packing: a pore is a tetrahedron of the weighted Delaunay triangulation, a "
        "throat a facet. Made of a World, or of cell, positions and radii [m]. Arrays look into it without copying."
    );
    type.def(
        py::init([](const py::object& first, const py::object& position, const py::object& radius) {
            const Packing packing = packing_of(first, position, radius);
            const py::gil_scoped_release released;
            return std::make_shared<PoreNetwork>(pores::build_network(packing.h, packing.position, packing.radius));
        }),
        py::arg("packing_or_cell"), py::arg("position") = py::none(), py::arg("radius") = py::none()
    );
    type.def_property_readonly(
        "cell", [](const PoreNetwork& net) { return to_array(net.h); }, "3 x 3: columns are the cell vectors [m]."
    );
    type.def_property_readonly(
        "pores", [](const PoreNetwork& net) { return net.pores.size(); }, "How many."
    );
    type.def_property_readonly(
        "throats", [](const PoreNetwork& net) { return net.throats.size(); }, "How many."
    );
    add_column(type, "pore_grain", &PoreNetwork::pores, &Pores::grain, "pores x 4: rows of the corners [-].");
    add_column(
        type, "pore_neighbor", &PoreNetwork::pores, &Pores::neighbor,
        "pores x 4: the pore across the facet opposite to each corner [-]."
    );
    add_column(
        type, "pore_throat", &PoreNetwork::pores, &Pores::throat, "pores x 4: the throat through that facet [-]."
    );
    add_column(
        type, "pore_center", &PoreNetwork::pores, &Pores::center, "pores x 3: power center of the four grains [m]."
    );
    add_column(type, "pore_volume", &PoreNetwork::pores, &Pores::volume, "pores: of the tetrahedron [m3].");
    add_column(type, "void_volume", &PoreNetwork::pores, &Pores::void_volume, "pores: without the grains [m3].");
    add_column(type, "side", &PoreNetwork::throats, &Throats::side, "throats x 2: the pores that it joins [-].");
    add_column(type, "throat_grain", &PoreNetwork::throats, &Throats::grain, "throats x 3: rows of its grains [-].");
    add_column(type, "area", &PoreNetwork::throats, &Throats::area, "throats x 3: vector from side 0 to side 1 [m2].");
    add_column(
        type, "void_area", &PoreNetwork::throats, &Throats::void_area, "throats: without its sections of grains [m2]."
    );
    add_column(
        type, "hydraulic_radius", &PoreNetwork::throats, &Throats::hydraulic_radius,
        "throats: volume of its water over the surface that it wets [m]."
    );
    add_column(
        type, "inscribed_radius", &PoreNetwork::throats, &Throats::inscribed_radius,
        "throats: of the circle between its grains, the constriction [m]."
    );
    add_column(type, "length", &PoreNetwork::throats, &Throats::length, "throats: between the pore centers [m].");
    add_column(
        type, "throat_center", &PoreNetwork::throats, &Throats::center,
        "throats x 3: center of the inscribed circle [m]."
    );
    add_column(type, "hidden", &PoreNetwork::hidden, "n: rows of grains that are buried in others [-].");
    type.def_property_readonly(
        "pore_grain_image", [](const Net& net) { return images(net->pores.grain_image, hold(net)); },
        "pores x 4 x 3: corner k is at position[pore_grain] + cell @ image [-]."
    );
    type.def(
        "constrictions",
        [](const PoreNetwork& net) { return std::make_shared<Constrictions>(pores::find_constrictions(net)); },
        "Its constrictions, one for each throat."
    );
    type.def(
        "widest_paths",
        [](const PoreNetwork& net, const py::object& direction) {
            const int axis = pores::axis_along(net.h, direction_of(direction));
            const py::gil_scoped_release released;
            return pores::widest_paths(net, axis);
        },
        py::arg("direction") = "z",
        "pores: the largest diameter that travels from it to its own image one period further [m]."
    );
}

std::vector<Vec3> pore_velocities_of(const SolvedSeepage& water) {
    return flow::pore_velocities(water.network, water.packing.position, water.packing.radius, water.field.flux);
}

std::shared_ptr<SolvedSeepage> seep(
    const py::object& first, const py::object& position, const py::object& radius, const py::object& gradient,
    const py::object& direction, const flow::Fluid& fluid, bool tensor
) {
    Packing packing = packing_of(first, position, radius);
    flow::FlowSpec spec;
    spec.gradient = quantity_of(gradient, dimension::none, "gradient");
    spec.direction = direction_of(direction);
    spec.tensor = tensor;
    const py::gil_scoped_release released;
    const cell::Cell cell{packing.h, {}};
    flow::Seepage seepage = flow::solve_seepage(cell, packing.position, packing.radius, spec, fluid);
    return std::make_shared<SolvedSeepage>(SolvedSeepage{std::move(seepage), std::move(packing)});
}

void bind_seepage(py::module_& m) {
    using Water = std::shared_ptr<SolvedSeepage>;
    py::class_<SolvedSeepage, Water> type(
        m, "Seepage", "Steady flow through a frozen packing, and what it does to the grains."
    );
    type.def_property_readonly(
        "network", [](const Water& water) { return std::shared_ptr<PoreNetwork>(water, &water->network); },
        "The pore network that the water flows through."
    );
    add_column(type, "conductance", &Seepage::conductance, "throats: flux per difference of pressure [m3/(Pa s)].");
    add_column(type, "pressure", &Seepage::field, &flow::FlowField::pressure, "pores: excess pressure [Pa].");
    add_column(type, "flux", &Seepage::field, &flow::FlowField::flux, "throats: from side 0 to side 1 [m3/s].");
    add_column(
        type, "grain_force", &Seepage::grain_force, "grains x 3: of the fluid on each grain, without buoyancy [N]."
    );
    type.def_readonly("permeability", &Seepage::permeability, "Intrinsic, along the direction [m2].");
    type.def_property_readonly(
        "tensor",
        [](const SolvedSeepage& water) -> py::object {
            return water.tensor ? py::object(to_array(*water.tensor)) : py::object(py::none());
        },
        "3 x 3: permeability, where asked; else None [m2]."
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
        "pores x 3: mean velocity of the water in each pore, reckoned anew at each look [m/s]."
    );
    type.def_property_readonly(
        "tortuosity",
        [](const SolvedSeepage& water) { return flow::tortuosity(water.network, pore_velocities_of(water)); },
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
                            "\ntensor: " + key_doc(key_of("stage.flow", "tensor"));
    m.def(
        "seep", &seep, py::arg("packing_or_cell"), py::arg("position") = py::none(), py::arg("radius") = py::none(),
        py::kw_only(), py::arg("gradient") = 0.0, py::arg("direction") = "z", py::arg("fluid") = flow::Fluid{},
        py::arg("tensor") = false, doc.c_str()
    );
}

} // namespace

void bind_water(py::module_& m) {
    bind_constrictions(m);
    bind_network(m);
    bind_seepage(m);
}

} // namespace suffuse::python
