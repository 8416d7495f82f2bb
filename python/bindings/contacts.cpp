#include "python/bindings/contacts.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/version.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/views.hpp"
#include <algorithm>
#include <string_view>
#include <type_traits>

namespace suffuse::python {
namespace {

using Contacts = std::shared_ptr<ContactTable>;

void add_contact_vectors(
    py::class_<ContactTable, Contacts>& type, const char* name, Vec3 dem::ContactView::*field, const char* doc
) {
    type.def_property_readonly(
        name,
        [field](const Contacts& table) {
            const double* first = table->rows.empty() ? nullptr : &(table->rows.front().*field).x;
            return look_at(first, table->rows.size(), 3, sizeof(dem::ContactView), hold(table));
        },
        doc
    );
}

template <class T>
void add_contact_column(
    py::class_<ContactTable, Contacts>& type, const char* name, T dem::ContactView::*field, const char* doc
) {
    type.def_property_readonly(
        name,
        [field](const Contacts& table) {
            const T* first = table->rows.empty() ? nullptr : &(table->rows.front().*field);
            return look_at(first, table->rows.size(), 0, sizeof(dem::ContactView), hold(table));
        },
        doc
    );
}

/// Bytes of 0 or 1 as NumPy's booleans, which are stored alike.
void add_claim(
    py::class_<ContactTable, Contacts>& type, const char* name, std::vector<std::uint8_t> dem::ContactsAtLimit::*column,
    const char* doc
) {
    type.def_property_readonly(
        name,
        [column](const Contacts& table) {
            const std::vector<std::uint8_t>& values = table->limits.*column;
            return look_at(reinterpret_cast<const bool*>(values.data()), values.size(), 0, 1, hold(table));
        },
        doc
    );
}

template <class T>
py::bytes bytes_of(const std::vector<T>& rows) {
    static_assert(std::is_trivially_copyable_v<T>);
    return {reinterpret_cast<const char*>(rows.data()), rows.size() * sizeof(T)};
}

template <class T>
void take_bytes(const py::handle& bytes, std::size_t rows, std::vector<T>& column) {
    const auto held = bytes.cast<std::string_view>();
    if (held.size() != rows * sizeof(T)) {
        throw IoError("pickled contacts are damaged");
    }
    column.resize(rows);
    std::copy(held.begin(), held.end(), reinterpret_cast<char*>(column.data()));
}

/// For another process, of the same build: rows as they are in memory.
py::tuple take_contacts_apart(const ContactTable& table) {
    return py::make_tuple(
        commit(), table.rows.size(), bytes_of(table.rows), bytes_of(table.limits.sliding),
        bytes_of(table.limits.rolling)
    );
}

Contacts put_contacts_together(const py::tuple& state) {
    if (state[0].cast<std::string>() != commit()) {
        throw IoError("these contacts were pickled by another build of suffuse: pickle the World, and take its contacts"
        );
    }
    const auto rows = state[1].cast<std::size_t>();
    ContactTable table;
    take_bytes(state[2], rows, table.rows);
    take_bytes(state[3], rows, table.limits.sliding);
    take_bytes(state[4], rows, table.limits.rolling);
    return std::make_shared<ContactTable>(std::move(table));
}

} // namespace

Contacts take_contacts(const dem::World& world) {
    return std::make_shared<ContactTable>(ContactTable{dem::inspect_contacts(world), dem::find_contacts_at_limit(world)}
    );
}

void bind_contacts(py::module_& m) {
    using dem::ContactView;
    py::class_<ContactTable, Contacts> type(
        m, "Contacts",
        "The touching contacts as the last step left them, or, before the first one, as the geometry has them: a row "
        "each. Later steps do not change them."
    );
    type.def("__len__", [](const ContactTable& table) { return table.rows.size(); });
    type.def("__repr__", [](const ContactTable& table) {
        const auto sliding = std::ranges::count(table.limits.sliding, 1),
                   rolling = std::ranges::count(table.limits.rolling, 1);
        return fmt::format("<suffuse.Contacts: {}, {} sliding, {} rolling>", table.rows.size(), sliding, rolling);
    });
    type.def(py::pickle(&take_contacts_apart, &put_contacts_together));
    add_contact_column(type, "i", &ContactView::i, "contacts: row of the first grain [-].");
    add_contact_column(type, "j", &ContactView::j, "contacts: row of the second grain [-].");
    add_contact_column(type, "overlap", &ContactView::overlap, "contacts: sum of the radii less the distance [m].");
    add_contact_vectors(type, "normal", &ContactView::normal, "contacts x 3: from the first grain to the second [-].");
    add_contact_vectors(type, "normal_force", &ContactView::normal_force, "contacts x 3: on the first grain [N].");
    add_contact_vectors(type, "shear_force", &ContactView::shear_force, "contacts x 3: on the first grain [N].");
    add_contact_vectors(
        type, "moment", &ContactView::moment, "contacts x 3: bending and twisting, on the first grain [N m]."
    );
    type.def_property_readonly(
        "image",
        [](const Contacts& table) {
            static_assert(sizeof(cell::Image) == 3 * sizeof(std::int16_t));
            const std::int16_t* first = table->rows.empty() ? nullptr : &table->rows.front().image.a;
            return look_at(first, table->rows.size(), 3, sizeof(ContactView), hold(table));
        },
        "contacts x 3: periods by which the second grain is moved, it is met at position[j] + cell @ image [-]."
    );
    add_claim(
        type, "sliding", &dem::ContactsAtLimit::sliding,
        "contacts: |shear force| = tan(friction) x normal force: all that Coulomb friction bears; never of a bond."
    );
    add_claim(
        type, "rolling", &dem::ContactsAtLimit::rolling,
        "contacts: |bending moment| = rolling_friction x the smaller radius x |normal force|: all that rolling "
        "resistance bears; never where rolling_friction is negative, which is no limit."
    );
    type.def_property_readonly(
        "compression",
        [](const ContactTable& table) {
            py::array_t<double> values(static_cast<py::ssize_t>(table.rows.size()));
            double* out = values.mutable_data();
            for (const ContactView& c : table.rows) {
                *out++ = -dot(c.normal_force, c.normal);
            }
            return values;
        },
        "contacts: normal force, compression positive [N]; a new array."
    );
}

} // namespace suffuse::python
