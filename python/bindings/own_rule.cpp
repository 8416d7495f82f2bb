#include "python/bindings/own_rule.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/interpreter.hpp"
#include "python/bindings/views.hpp"
#include "python/bindings/world_handle.hpp"
#include <memory>
#include <string>

namespace suffuse::python {
namespace {

/// What a rule is given.
struct Probe {
    erosion::ProbeResult result;
    std::shared_ptr<WorldHandle> world; ///< a copy of the equilibrium
    std::vector<std::int64_t> row;      ///< of each fine grain there
};

using Held = std::shared_ptr<Probe>;

Held make_probe(const dem::World& equilibrium, const erosion::ProbeResult& result) {
    auto probe = std::make_shared<Probe>();
    probe->result = result;
    probe->world = std::make_shared<WorldHandle>(equilibrium);
    for (std::size_t g = 0; g < equilibrium.grains.size(); ++g) {
        if (equilibrium.grains.fine[g] != 0) {
            probe->row.push_back(static_cast<std::int64_t>(g));
        }
    }
    return probe;
}

/// A truth value for each fine grain. @throws CaseError for anything else: numbers might be rows
std::vector<std::uint8_t> mask_of(const py::object& given, std::size_t fines, const std::string& name) {
    const auto array = py::array(given);
    if (array.dtype().kind() != 'b' || array.ndim() != 1 || static_cast<std::size_t>(array.size()) != fines) {
        throw CaseError(fmt::format(
            "rule: {} returned {} of {}, expected a truth value for each of the {} fines of the probe", name,
            py::str(array.attr("shape")).cast<std::string>(), py::str(array.dtype()).cast<std::string>(), fines
        ));
    }
    const auto values = array.cast<py::array_t<bool>>();
    const auto look = values.unchecked<1>();
    std::vector<std::uint8_t> mask(fines);
    for (std::size_t k = 0; k < fines; ++k) {
        mask[k] = look(static_cast<py::ssize_t>(k)) ? 1 : 0;
    }
    return mask;
}

std::string name_of(const py::handle& function) {
    const py::handle named = py::hasattr(function, "__qualname__") ? function : py::type::handle_of(function);
    return named.attr("__qualname__").cast<std::string>();
}

/// Its text; empty where Python does not know it, as of what is made of other functions or typed at a plain prompt.
std::string source_of(const py::handle& function) {
    try {
        const py::object text = py::module_::import("inspect").attr("getsource")(function);
        return py::module_::import("textwrap").attr("dedent")(text).cast<std::string>();
    } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_OSError) && !error.matches(PyExc_TypeError)) {
            throw;
        }
        return {};
    }
}

template <class T>
void measured(py::class_<Probe, Held>& type, const char* name, T erosion::ProbeResult::*column, const char* doc) {
    type.def_property_readonly(
        name, [column](const Held& probe) { return look_at(probe->result.*column, hold(probe)); }, doc
    );
}

template <class T>
void add_number(py::class_<Probe, Held>& type, const char* name, T erosion::ProbeResult::*number, const char* doc) {
    type.def_property_readonly(
        name, [number](const Held& probe) { return probe->result.*number; }, doc
    );
}

void judged(
    py::class_<Probe, Held>& type, const char* name, std::vector<std::uint8_t> erosion::ProbeResult::*column,
    const char* doc
) {
    type.def_property_readonly(
        name,
        [column](const Held& probe) {
            return py::array(look_at(probe->result.*column, hold(probe)).attr("astype")("bool"));
        },
        doc
    );
}

} // namespace

erosion::OwnRule own_rule_of(py::handle function, InInterpreter call) {
    if (PyCallable_Check(function.ptr()) == 0) {
        throw CaseError(fmt::format(
            "rule: found {}, expected a function from a Probe to a truth value for each of its fines",
            py::repr(function).cast<std::string>()
        ));
    }
    const std::string name = name_of(function);
    return {
        name, source_of(function),
        [function, name, call = std::move(call)](const dem::World& world, const erosion::ProbeResult& result) {
            std::vector<std::uint8_t> mask;
            call([&] {
                const py::tuple arguments = py::make_tuple(make_probe(world, result));
                mask = mask_of(call_function(function, arguments), result.id.size(), name);
            });
            return mask;
        }};
}

void bind_own_rule(py::module_& m) {
    using Result = erosion::ProbeResult;
    py::class_<Probe, Held> type(
        m, "Probe",
        "What the probe of an erosion measured: a row a fine grain. A detachment rule is a function from it to a truth "
        "value for each."
    );
    type.def("__len__", [](const Held& probe) { return probe->result.id.size(); });
    type.def("__repr__", [](const Held& probe) {
        return fmt::format(
            "<suffuse.Probe: {} fines at a gradient of {:g}>", probe->result.id.size(), probe->result.gradient
        );
    });
    type.def_property_readonly(
        "world", [](const Held& probe) { return probe->world; },
        "A copy of the equilibrium that the probe started from: a World."
    );
    type.def_property_readonly(
        "row", [](const Held& probe) { return look_at(probe->row, hold(probe)); },
        "fines: row in the grains of `world`, as in world.grains.position[probe.row]."
    );
    measured(type, "id", &Result::id, "fines: id of the grain.");
    measured(type, "diameter", &Result::diameter, "fines: [m].");
    measured(type, "fluid_force", &Result::fluid_force, "fines: magnitude of the fluid's force [N].");
    measured(type, "coordination", &Result::coordination, "fines: contacts in the equilibrium [-].");
    measured(type, "speed", &Result::speed, "fines x 11: at full force, and after each tenth of the watch [m/s].");
    measured(type, "twin_speed", &Result::twin_speed, "fines: at the end, of the same grain without fluid [m/s].");
    measured(
        type, "displacement", &Result::displacement, "fines: along the drag at the end, relative to the twin [m]."
    );
    measured(type, "free_speed", &Result::free_speed, "fines: at the end, of the same grain without contacts [m/s].");
    measured(type, "free_displacement", &Result::free_displacement, "fines: of the same grain without contacts [m].");
    judged(type, "by_velocity", &Result::by_velocity, "fines: the verdict of the built-in rule on speeds.");
    judged(
        type, "by_displacement", &Result::by_displacement, "fines: the verdict of the built-in rule on displacements."
    );
    add_number(type, "gradient", &Result::gradient, "Hydraulic gradient i [-].");
    add_number(type, "time_step", &Result::time_step, "[s].");
    add_number(type, "ramp", &Result::ramp, "Steps from no force to the full one.");
    add_number(type, "watch", &Result::watch, "Steps at the full force.");
    add_number(type, "unbalanced_force", &Result::unbalanced_force, "Of the state that the probe started from [-].");
    add_number(
        type, "signal_over_twin", &Result::signal_over_twin, "Median speed with fluid over that of the twin [-]."
    );
}

} // namespace suffuse::python
