// The columns of the grain table for NumPy. Nothing else in the module knows how they are stored.

#include "suffuse/grains/grains.hpp"

#include "python/bindings/views.hpp"
#include "python/bindings/world_handle.hpp"

namespace suffuse::python {
namespace {

namespace py = pybind11;
using grains::Grains;

py::capsule owner_of(const GrainTable& table) {
    return hold(std::pair(table.handle, table.handle->rows_of_views()));
}

template <class T>
py::array view(const GrainTable& table, std::vector<T> Grains::*column, bool writeable) {
    return look_at(table.handle->world().grains.*column, owner_of(table), writeable);
}

/// Bytes of 0 or 1 as NumPy's booleans, which are stored alike.
template <class Byte>
py::array bool_view(const GrainTable& table, std::vector<Byte> Grains::*column) {
    static_assert(sizeof(Byte) == sizeof(bool));
    const std::vector<Byte>& values = table.handle->world().grains.*column;
    return look_at(reinterpret_cast<const bool*>(values.data()), values.size(), 0, 1, owner_of(table), true);
}

template <class View>
auto assign_through(View view) {
    return [view](const GrainTable& table, const py::object& values) { view(table)[py::ellipsis()] = values; };
}

template <class Column>
void add_grain_column(py::class_<GrainTable>& type, const char* name, Column Grains::*column, const char* doc) {
    type.def_property_readonly(
        name, [column](const GrainTable& table) { return view(table, column, false); }, doc
    );
}

void add_vectors(py::class_<GrainTable>& type, const char* name, std::vector<Vec3> Grains::*column, const char* doc) {
    const auto look = [column](const GrainTable& table) { return view(table, column, true); };
    type.def_property(name, look, assign_through(look), doc);
}

template <class Byte>
void add_claim(py::class_<GrainTable>& type, const char* name, std::vector<Byte> Grains::*column, const char* doc) {
    const auto look = [column](const GrainTable& table) { return bool_view(table, column); };
    type.def_property(name, look, assign_through(look), doc);
}

} // namespace

void bind_grain_columns(py::class_<GrainTable>& type) {
    add_vectors(
        type, "position", &Grains::position, "grains x 3: centers, not wrapped into the cell [m]; may be changed."
    );
    add_vectors(type, "velocity", &Grains::velocity, "grains x 3: with the cell's mean motion [m/s]; may be changed.");
    add_vectors(type, "spin", &Grains::spin, "grains x 3: angular velocity [rad/s]; may be changed.");
    add_claim(type, "fine", &Grains::fine, "grains: belongs to the fine fraction, true or false; may be changed.");
    add_claim(
        type, "held", &Grains::motion,
        "grains: keeps its velocity and spin, whatever the forces, true or false; may be changed."
    );
    add_grain_column(type, "force", &Grains::force, "grains x 3: contact force of the last step [N].");
    add_grain_column(type, "torque", &Grains::torque, "grains x 3: contact torque of the last step [N m].");
    add_grain_column(type, "radius", &Grains::radius, "grains: of the sphere [m].");
    add_grain_column(type, "mass", &Grains::mass, "grains: density x volume [kg].");
    add_grain_column(type, "inertia", &Grains::inertia, "grains: 0.4 mass x radius^2 [kg m2].");
    add_grain_column(type, "id", &Grains::id, "grains: number of each, stable, never reused [-].");
}

} // namespace suffuse::python
