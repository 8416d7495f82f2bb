#pragma once
// A packing as pores and water see it, and the network of its pores.

#include "suffuse/pores/network.hpp"

#include "python/bindings/convert.hpp"
#include "python/bindings/views.hpp"
#include <memory>

namespace suffuse::python {

/// Of a World, or cell, positions and radii as the caller gives them.
struct Packing {
    Mat3 h;
    std::vector<Vec3> position;
    std::vector<double> radius;
    std::vector<std::uint8_t> fine; ///< of a World only: arrays do not have it
};

/// @param first a World, what has one (a stage of a run), the network of a packing, or a cell. @throws CaseError where
/// it is no packing
Packing packing_of(const py::object& first, const py::object& position, const py::object& radius);

/// For another process, and back.
py::tuple to_tuple(const Packing& packing);
Packing from_tuple(const py::tuple& state);

/// A network, and the packing that it is of.
struct PackedNetwork : pores::PoreNetwork {
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

} // namespace suffuse::python
