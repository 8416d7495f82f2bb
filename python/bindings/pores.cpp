// Pore networks and constrictions, of a world or of any packing given as arrays.

#include "suffuse/pores/constrictions.hpp"
#include "suffuse/pores/network.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/packing.hpp"
#include "python/bindings/typed.hpp"
#include "python/bindings/work.hpp"
#include "python/bindings/world_handle.hpp"

namespace suffuse::python {

Packing packing_of(const py::object& first, const py::object& position, const py::object& radius) {
    const bool is_packing =
        py::isinstance<WorldHandle>(first) || py::isinstance<PackedNetwork>(first) || py::hasattr(first, "world");
    if (is_packing && !(position.is_none() && radius.is_none())) {
        throw CaseError(
            "position, radius: the packing that comes first has its own; leave them out, and name what follows, as in "
            "gradient=0.3"
        );
    }
    if (py::isinstance<WorldHandle>(first)) {
        const dem::World& world = first.cast<const WorldHandle&>().world();
        return {world.cell.h, world.grains.position, world.grains.radius, world.grains.fine};
    }
    if (py::isinstance<PackedNetwork>(first)) {
        return first.cast<const PackedNetwork&>().packing;
    }
    if (py::hasattr(first, "world")) { // a stage of a run
        return packing_of(first.attr("world"), position, radius);
    }
    if (position.is_none() || radius.is_none()) {
        throw CaseError("a packing is a World, or its cell, positions and radii");
    }
    Packing packing{cell_of(first), vectors_of(position, "position"), {}, {}};
    packing.radius = numbers_of(radius, "radius", packing.position.size());
    return packing;
}

py::tuple to_tuple(const Packing& packing) {
    const auto& [h, position, radius, fine] = packing;
    return py::make_tuple(
        to_array(h), to_array(position), py::array_t<double>(static_cast<py::ssize_t>(radius.size()), radius.data()),
        py::bytes(reinterpret_cast<const char*>(fine.data()), fine.size())
    );
}

Packing from_tuple(const py::tuple& state) {
    Packing packing = packing_of(state[0], state[1], state[2]);
    const auto fine = state[3].cast<std::string>();
    packing.fine.assign(fine.begin(), fine.end());
    return packing;
}

namespace {

using pores::Constrictions;
using pores::PoreNetwork;

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

std::shared_ptr<Constrictions> constrictions_of(Packing packing, const std::string& of, const std::string& merge) {
    const pores::VoidMerge way = merge_of(merge);
    if (of != "all" && of != "coarse") {
        throw CaseError("constrictions: of is \"all\" or \"coarse\"; found \"" + of + "\"");
    }
    if (of == "coarse") {
        if (packing.fine.empty()) {
            throw CaseError("constrictions of the coarse grains need a World, which knows its fines");
        }
        std::size_t kept = 0;
        for (std::size_t g = 0; g < packing.fine.size(); ++g) {
            if (packing.fine[g] == 0) {
                packing.position[kept] = packing.position[g];
                packing.radius[kept++] = packing.radius[g];
            }
        }
        packing.position.resize(kept);
        packing.radius.resize(kept);
    }
    const Computing computing;
    return std::make_shared<Constrictions>(pores::find_constrictions(packing.h, packing.position, packing.radius, way));
}

constexpr const char* merge_doc =
    "\n\nof: \"all\", or \"coarse\": of the coarse skeleton of a World"
    "\nmerge: which neighboring pores are one void, with no constriction between them: \"none\" (each facet counts), "
    "\"center\" (the center of the void sphere of one lies in that of the other), \"overlap\" (their void spheres "
    "overlap)";

py::tuple take_constrictions_apart(const Constrictions& c) {
    return py::make_tuple(
        py::array_t<double>(static_cast<py::ssize_t>(c.diameter.size()), c.diameter.data()), to_array(c.center), c.mean,
        c.median, c.d35
    );
}

Constrictions put_constrictions_together(const py::tuple& state) {
    Constrictions c;
    c.diameter = numbers_of(state[0], "diameter");
    c.center = vectors_of(state[1], "center", c.diameter.size());
    c.mean = state[2].cast<double>(), c.median = state[3].cast<double>(), c.d35 = state[4].cast<double>();
    return c;
}

void bind_constrictions(py::module_& m) {
    py::class_<Constrictions, std::shared_ptr<Constrictions>> type(
        m, "Constrictions",
        "The largest spheres that pass the facets of the weighted Delaunay triangulation that lie between voids."
    );
    type.def("__len__", [](const Constrictions& c) { return c.diameter.size(); });
    type.def("__repr__", [](const Constrictions& c) {
        return fmt::format("<suffuse.Constrictions: {}, mean {:.4g} mm>", c.diameter.size(), 1e3 * c.mean);
    });
    type.def(py::pickle(&take_constrictions_apart, &put_constrictions_together));
    add_column(type, "diameter", &Constrictions::diameter, "constrictions: of the sphere [m].");
    add_column(type, "center", &Constrictions::center, "constrictions x 3: of the sphere, in its facet [m].");
    type.def_readonly("mean", &Constrictions::mean, "Mean diameter by number of facets [m].");
    type.def_readonly("median", &Constrictions::median, "Half of the facets are smaller [m].");
    type.def_readonly("d35", &Constrictions::d35, "35 % of the facets are smaller [m].");
    m.def(
        "constrictions",
        [](const PackingOrCell& first, const NumbersOrNone& position, const NumbersOrNone& radius,
           const std::string& of,
           const std::string& merge) { return constrictions_of(packing_of(first, position, radius), of, merge); },
        py::arg("packing_or_cell"), py::arg("position") = py::none(), py::arg("radius") = py::none(), py::kw_only(),
        py::arg("of") = "all", py::arg("merge") = "none",
        (std::string("Constrictions between the grains of a World, or of cell, positions and radii [m].") + merge_doc)
            .c_str()
    );
}

std::shared_ptr<PackedNetwork> build(Packing packing) {
    const Computing computing;
    PoreNetwork network = pores::build_network(packing.h, packing.position, packing.radius);
    return std::make_shared<PackedNetwork>(PackedNetwork{std::move(network), std::move(packing)});
}

void bind_network(py::module_& m) {
    using pores::Pores;
    using pores::Throats;
    using Net = std::shared_ptr<PackedNetwork>;
    py::class_<PackedNetwork, Net> type(
        m, "PoreNetwork",
        "The pore network of a periodic packing: a pore is a tetrahedron of the weighted Delaunay triangulation, a "
        "throat a facet. Made of a World, or of cell, positions and radii [m]. Arrays look into it without copying. It "
        "travels to another process as its packing, and is built again there, to the same bits."
    );
    type.def(
        py::init([](const PackingOrCell& first, const NumbersOrNone& position, const NumbersOrNone& radius) {
            return build(packing_of(first, position, radius));
        }),
        py::arg("packing_or_cell"), py::arg("position") = py::none(), py::arg("radius") = py::none()
    );
    type.def(py::pickle(
        [](const PackedNetwork& net) { return to_tuple(net.packing); },
        [](const py::tuple& state) { return build(from_tuple(state)); }
    ));
    type.def("__repr__", [](const PackedNetwork& net) {
        return fmt::format("<suffuse.PoreNetwork: {} pores, {} throats>", net.pores.size(), net.throats.size());
    });
    type.def_property_readonly(
        "cell", [](const PackedNetwork& net) { return to_array(net.h); }, "3 x 3: columns are the cell vectors [m]."
    );
    add_column(type, "position", &PackedNetwork::packing, &Packing::position, "grains x 3: centers, as given [m].");
    add_column(type, "radius", &PackedNetwork::packing, &Packing::radius, "grains: of the sphere, as given [m].");
    type.def_property_readonly(
        "pores", [](const PackedNetwork& net) { return net.pores.size(); }, "How many."
    );
    type.def_property_readonly(
        "throats", [](const PackedNetwork& net) { return net.throats.size(); }, "How many."
    );
    add_column(type, "pore_grain", &PoreNetwork::pores, &Pores::grain, "pores x 4: rows of the corners [-].");
    type.def_property_readonly(
        "pore_neighbor",
        [](const PackedNetwork& net) {
            const auto rows = std::make_shared<std::vector<std::array<std::uint32_t, 4>>>(net.pores.size());
            for (std::uint32_t p = 0; p < rows->size(); ++p) {
                for (std::size_t k = 0; k < 4; ++k) {
                    (*rows)[p][k] = pores::pore_beyond(net, p, k).pore;
                }
            }
            return look_at(*rows, hold(rows));
        },
        "pores x 4: the pore across the facet opposite to each corner, found anew at each access [-]."
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
    type.def_property_readonly(
        "throat_grain",
        [](const PackedNetwork& net) {
            const auto rows = std::make_shared<std::vector<std::array<std::uint32_t, 3>>>(net.throats.size());
            for (std::size_t t = 0; t < rows->size(); ++t) {
                (*rows)[t] = pores::grains_of(net, t).row;
            }
            return look_at(*rows, hold(rows));
        },
        "throats x 3: rows of its grains, found anew at each access [-]."
    );
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
        "throats: of the largest free sphere centered in the facet, the constriction [m]."
    );
    add_column(type, "length", &PoreNetwork::throats, &Throats::length, "throats: between the pore centers [m].");
    add_column(
        type, "throat_center", &PoreNetwork::throats, &Throats::center, "throats x 3: center of that sphere [m]."
    );
    add_column(type, "hidden", &PoreNetwork::hidden, "n: rows of grains that are buried in others [-].");
    type.def_property_readonly(
        "pore_grain_image", [](const Net& net) { return images(net->pores.grain_image, hold(net)); },
        "pores x 4 x 3: corner k is at position[pore_grain] + cell @ image [-]."
    );
    type.def(
        "constrictions",
        [](const PackedNetwork& net, const std::string& of, const std::string& merge) {
            return of == "all" && merge == "none" ? std::make_shared<Constrictions>(pores::find_constrictions(net))
                                                  : constrictions_of(net.packing, of, merge);
        },
        py::arg("of") = "all", py::arg("merge") = "none", (std::string("Its constrictions.") + merge_doc).c_str()
    );
    type.def(
        "widest_paths",
        [](const PackedNetwork& net, const Direction& direction) {
            const int axis = pores::axis_along(net.h, direction_of(direction));
            std::vector<double> widest;
            {
                const Computing computing;
                widest = pores::widest_paths(net, axis);
            }
            return py::array_t<double>(static_cast<py::ssize_t>(widest.size()), widest.data());
        },
        py::arg("direction") = "z",
        "pores: the largest diameter that travels from it to its own image one period further [m]."
    );
}

} // namespace

void bind_pores(py::module_& m) {
    bind_constrictions(m);
    bind_network(m);
}

} // namespace suffuse::python
