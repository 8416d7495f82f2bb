// Material, fluid, balance and loading: the same Specs as a case file's, with the same words.

#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/cell/servo.hpp"
#include "suffuse/dem/spec.hpp"
#include "suffuse/flow/fluid.hpp"
#include "suffuse/grains/material.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/key_doc.hpp"
#include "python/bindings/key_value.hpp"
#include "python/bindings/typed.hpp"
#include <array>
#include <type_traits>
#include <utility>

namespace suffuse::python {
namespace {

using casefile::Key;

/// A field that a key of the case sets, documented by the schema.
template <class Spec>
void quantity_field(py::class_<Spec>& type, const char* table, const char* name, double Spec::*field) {
    const Key& key = key_of(table, name);
    type.def_property(
        name, [field](const Spec& spec) { return spec.*field; },
        [field, name, &key](Spec& spec, const Quantity& value) { spec.*field = value_of(key, value, name); },
        key_doc(key).c_str()
    );
}

template <class Spec>
void quantity_field(py::class_<Spec>& type, const char* table, const char* name, std::optional<double> Spec::*field) {
    const Key& key = key_of(table, name);
    type.def_property(
        name, [field](const Spec& spec) { return spec.*field; },
        [field, name, &key](Spec& spec, const QuantityOrNone& value) {
            spec.*field = optional_value_of(key, value, name);
        },
        key_doc(key).c_str()
    );
}

template <class Spec>
Spec from_fields(const py::dict& given, const std::vector<const char*>& fields) {
    py::object made = py::cast(Spec{});
    for (const auto& [name, value] : given) {
        if (!py::hasattr(made, name)) {
            const auto word = py::str(name).cast<std::string>();
            throw py::type_error(fmt::format(
                "there is no field {}{}; there are {}", shown(word), near_hint(word, {fields.begin(), fields.end()}),
                fmt::join(fields, ", ")
            ));
        }
        py::setattr(made, name, value);
    }
    return made.cast<Spec>();
}

/// Keyword arguments as assignments, so that they are checked and named alike; a text, an equality and a pickle of the
/// same fields.
template <class Spec>
void make_value(py::class_<Spec>& type, const std::vector<const char*>& fields) {
    const auto values = [fields](const py::object& self) {
        py::dict dict;
        for (const char* field : fields) {
            dict[field] = self.attr(field);
        }
        return dict;
    };
    type.def(py::init([fields](const py::kwargs& given) { return from_fields<Spec>(given, fields); }));
    type.def(py::pickle(values, [fields](const py::dict& given) { return from_fields<Spec>(given, fields); }));
    type.def("__eq__", [values](const py::object& self, const py::object& other) {
        return py::isinstance<Spec>(other) && values(self).equal(values(other));
    });
    type.def("__repr__", [values](const py::object& self) {
        std::string text;
        for (const auto& [field, value] : values(self)) {
            text += fmt::format(
                "{}{}={}", text.empty() ? "" : ", ", field.template cast<std::string>(),
                py::repr(value).template cast<std::string>()
            );
        }
        return fmt::format("{}({})", py::type::of(self).attr("__name__").template cast<std::string>(), text);
    });
}

/// The number of that name among the members of a material.
double& number_in(grains::Material& material, std::string_view name) {
    double* found = nullptr;
    grains::list_members(material, [&](const grains::Member& member, auto& value) {
        if constexpr (std::is_same_v<decltype(value), double&>) {
            found = name == member.name ? &value : found;
        }
    });
    expects(found != nullptr, "a material has the members that it lists");
    return *found;
}

/// The key of the case that sets a member of the material.
const Key& key_of_member(std::string_view name) {
    constexpr std::string_view adhesion = "adhesion_";
    if (name.starts_with(adhesion)) {
        return key_of("contact.adhesion", name.substr(adhesion.size()));
    }
    return key_of(name == "density" ? "grain" : "contact", name);
}

void bind_member(py::class_<grains::Material>& type, const char* name, double) {
    const Key& key = key_of_member(name);
    const char* given_name = key.table == "contact.adhesion" ? "adhesion" : name;
    type.def_property(
        name, [name](grains::Material material) { return number_in(material, name); },
        [name, given_name, &key](grains::Material& material, const Quantity& value) {
            number_in(material, name) = value_of(key, value, given_name);
        },
        key_doc(key).c_str()
    );
}

void bind_member(py::class_<grains::Material>& type, const char* name, grains::ContactLaw) {
    type.def_property(
        name,
        [](const grains::Material& material) {
            return std::string(casefile::names::word_for(casefile::names::law, material.law));
        },
        [name](grains::Material& material, const std::string& word) {
            material.law = word_of(word, casefile::names::law, name);
        },
        key_doc(key_of_member(name)).c_str()
    );
}

void bind_material(py::module_& m) {
    py::class_<grains::Material> type(m, "Material", "The constants of the contact law; keywords set fields.");
    const grains::Material usual;
    std::vector<const char*> names;
    grains::list_members(usual, [&](const grains::Member& member, const auto& value) {
        names.push_back(member.name);
        bind_member(type, member.name, value);
    });
    make_value(type, names);
}

void bind_fluid(py::module_& m) {
    using flow::Fluid;
    py::class_<Fluid> type(m, "Fluid", "The pore fluid; keywords set fields.");
    quantity_field(type, "fluid", "density", &Fluid::density);
    quantity_field(type, "fluid", "viscosity", &Fluid::viscosity);
    quantity_field(type, "fluid", "bulk_modulus", &Fluid::bulk_modulus);
    const Key& conductance = key_of("fluid", "conductance");
    type.def_property(
        "conductance",
        [](const Fluid& fluid) { return casefile::names::word_for(casefile::names::conductance, fluid.conductance); },
        [](Fluid& fluid, const std::string& word) {
            fluid.conductance = word_of(word, casefile::names::conductance, "conductance");
        },
        key_doc(conductance).c_str()
    );
    make_value(type, {"density", "viscosity", "conductance", "bulk_modulus"});
}

void bind_balance(py::module_& m) {
    using dem::BalanceSpec;
    py::class_<BalanceSpec> type(m, "Balance", "When a state counts as settled; keywords set fields.");
    quantity_field(type, "balance", "unbalanced_force", &BalanceSpec::unbalanced_force);
    quantity_field(type, "balance", "stress_error", &BalanceSpec::stress_error);
    const Key& patience = key_of("balance", "patience");
    type.def_property(
        "patience", [](const BalanceSpec& spec) { return spec.patience; },
        [&patience](BalanceSpec& spec, std::int64_t value) { spec.patience = count_of(patience, value, "patience"); },
        key_doc(patience).c_str()
    );
    make_value(type, {"unbalanced_force", "stress_error", "patience"});
}

/// One value for all axes, or three of them; None where the other way of control has the axis.
/// @param[in,out] taken axes that have a value
void take_axes(const py::object& given, cell::Control control, cell::Loading& loading, std::array<bool, 3>& taken) {
    if (given.is_none()) {
        return;
    }
    const bool is_stress = control == cell::Control::Stress;
    const std::string_view what = is_stress ? "stress" : "strain_rate";
    const Dimension dimension = is_stress ? dimension::pressure : dimension::rate;
    const bool is_one = py::isinstance<py::str>(given) || !py::hasattr(given, "__len__");
    const auto parts = is_one ? py::make_tuple(given, given, given) : py::tuple(given);
    if (parts.size() != 3) {
        throw CaseError(fmt::format("{}: expected one value or three, found {}", what, parts.size()));
    }
    for (std::size_t a = 0; a < 3; ++a) {
        if (!parts[a].is_none()) {
            if (std::exchange(taken[a], true)) {
                throw CaseError(fmt::format(
                    "loading: axis {} has a stress and a strain rate; None in one of them leaves it to the other, as "
                    "in strain_rate=(None, None, 10), stress=(1e5, 1e5, None)",
                    a + 1
                ));
            }
            const double value = quantity_of(parts[a], dimension, what);
            if (is_stress && value < 0) {
                throw CaseError(fmt::format(
                    "stress: found {:.6g} Pa on axis {}, expected none below 0: compression is positive", value, a + 1
                ));
            }
            loading.axis[a] = {control, value};
        }
    }
}

using Axes = Typed<"float | str | Sequence[float | str | None] | None">;

cell::Loading make_loading(
    const Axes& stress, const Axes& strain_rate, const NumbersOrNone& velocity_gradient, const QuantityOrNone& max_rate,
    const std::string& shear_stresses
) {
    cell::Loading loading;
    if (!velocity_gradient.is_none()) {
        if (!stress.is_none() || !strain_rate.is_none()) {
            throw CaseError("loading: velocity_gradient replaces stress and strain_rate; give one or the other");
        }
        loading.velocity_gradient = matrix_of(velocity_gradient, dimension::rate, "velocity_gradient");
    }
    std::array<bool, 3> taken{};
    take_axes(strain_rate, cell::Control::StrainRate, loading, taken);
    take_axes(stress, cell::Control::Stress, loading, taken);
    loading.servo.max_rate = optional_value_of(key_of("stage.advance.servo", "max_rate"), max_rate, "max_rate");
    loading.shear_released = word_of(shear_stresses, casefile::names::shear_stresses, "shear_stresses");
    if (loading.shear_released && !cell::releases_shear(loading)) {
        throw CaseError("loading: shear_stresses = \"released\" needs a stress that is held, and there is none");
    }
    return loading;
}

/// The targets of the axes of this control, None at the others; None where there is no such axis.
py::object axes_of(const cell::Loading& loading, cell::Control control) {
    py::list values;
    bool any = false;
    for (const cell::AxisControl& axis : loading.axis) {
        const bool is_held = !loading.velocity_gradient && axis.control == control;
        values.append(is_held ? py::object(py::float_(axis.value)) : py::object(py::none()));
        any = any || is_held;
    }
    return any ? py::object(py::tuple(values)) : py::object(py::none());
}

/// In the order of the constructor.
py::tuple arguments_of(const cell::Loading& loading) {
    const auto& gradient = loading.velocity_gradient;
    return py::make_tuple(
        axes_of(loading, cell::Control::Stress), axes_of(loading, cell::Control::StrainRate),
        gradient ? py::object(to_array(*gradient).attr("tolist")()) : py::object(py::none()), loading.servo.max_rate,
        casefile::names::word_for(casefile::names::shear_stresses, loading.shear_released)
    );
}

void bind_loading(py::module_& m) {
    const std::string doc = fmt::format(
        "What drives the cell, per axis; one value serves all three, and None leaves an axis to the other argument, as "
        "in Loading(strain_rate=(None, None, 10), stress=(\"100 kPa\", \"100 kPa\", None)). An axis with neither stays "
        "as it is.\n\nstress: to hold along each axis, compression positive [Pa]\nstrain_rate: along each axis, "
        "compression positive [1/s]\nvelocity_gradient: 3 x 3, dv/dx of the cell, extension positive, instead of the "
        "other two [1/s]\nmax_rate: {}\nshear_stresses: {}",
        key_doc(key_of("stage.advance.servo", "max_rate")), key_doc(key_of("stage.settle", "shear_stresses"))
    );
    constexpr std::array fields{"stress", "strain_rate", "velocity_gradient", "max_rate", "shear_stresses"};
    constexpr std::array docs{
        "3: to hold along each axis, None where its strain rate is given; compression positive [Pa].",
        "3: along each axis, None where its stress is given; compression positive [1/s].",
        "3 x 3, a row each: dv/dx of the cell, or None [1/s].",
        "Largest strain rate under stress control, or None [1/s].",
        "\"kept\" or \"released\": whether the cell shears until there are no shear stresses between the axes."};
    py::class_<cell::Loading> type(m, "Loading", doc.c_str());
    type.def(
        py::init(&make_loading), py::arg("stress") = py::none(), py::arg("strain_rate") = py::none(), py::kw_only(),
        py::arg("velocity_gradient") = py::none(), py::arg("max_rate") = py::none(), py::arg("shear_stresses") = "kept"
    );
    for (std::size_t k = 0; k < fields.size(); ++k) {
        type.def_property_readonly(
            fields[k], [k](const cell::Loading& loading) { return py::object(arguments_of(loading)[k]); }, docs[k]
        );
    }
    type.def(py::pickle(&arguments_of, [](const py::tuple& state) {
        return make_loading(
            py::object(state[0]), py::object(state[1]), py::object(state[2]), py::object(state[3]),
            state[4].cast<std::string>()
        );
    }));
    type.def("__eq__", [](const cell::Loading& self, const py::object& other) {
        return py::isinstance<cell::Loading>(other) &&
               arguments_of(self).equal(arguments_of(other.cast<const cell::Loading&>()));
    });
    type.def("__repr__", [fields](const cell::Loading& loading) {
        const py::tuple values = arguments_of(loading);
        std::string text;
        for (std::size_t k = 0; k < fields.size(); ++k) {
            if (const py::object value = values[k]; !value.is_none() && !value.equal(py::str("kept"))) {
                const auto value_text = py::repr(value).cast<std::string>();
                text += fmt::format("{}{}={}", text.empty() ? "" : ", ", fields[k], value_text);
            }
        }
        return fmt::format("Loading({})", text);
    });
}

} // namespace

void bind_settings(py::module_& m) {
    bind_material(m);
    bind_fluid(m);
    bind_balance(m);
    bind_loading(m);
}

} // namespace suffuse::python
