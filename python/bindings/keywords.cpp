// A wrong name of an argument answered as the command line answers a wrong option: with the nearest that there is.
// pybind11 says then which arguments a function takes, in the words of C++; we look at the names first.

#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include <algorithm>

namespace suffuse::python {
namespace {

using Record = py::detail::function_record;

/// pybind11's own, the same for all of its functions.
PyCFunctionWithKeywords dispatch = nullptr;

std::string unknown_argument(const std::string& function, const std::string& name, std::vector<std::string> known) {
    return fmt::format(
        "{}: unknown argument {}{}; there are {}", function, shown(name), near_hint(name, known), fmt::join(known, ", ")
    );
}

/// Names of the arguments of all overloads; none where one takes any.
std::vector<std::string> names_of(const Record* record) {
    std::vector<std::string> names;
    for (; record != nullptr; record = record->next) {
        if (record->has_kwargs) {
            return {};
        }
        for (const py::detail::argument_record& argument : record->args) {
            const std::string name = argument.name == nullptr ? "" : argument.name;
            if (!name.empty() && name != "self" && std::ranges::find(names, name) == names.end()) {
                names.push_back(name);
            }
        }
    }
    return names;
}

std::string full_name(const Record& record) {
    const bool has_owner = record.scope && py::isinstance<py::type>(record.scope);
    const std::string owner = has_owner ? record.scope.attr("__name__").cast<std::string>() : "";
    const std::string name = record.name;
    return name == "__init__" ? owner : owner.empty() ? name : owner + "." + name;
}

/// What is to be said of a wrong name; empty where there is none.
std::string find_wrong(PyObject* self, const py::dict& named) {
    const py::error_scope raised; // stays, and is out of the way meanwhile
    const Record& record = *py::reinterpret_borrow<py::capsule>(self).get_pointer<Record>();
    const std::vector<std::string> names = names_of(&record);
    for (const auto& [key, value] : named) {
        const auto name = key.cast<std::string>();
        if (!names.empty() && std::ranges::find(names, name) == names.end()) {
            return unknown_argument(full_name(record), name, names);
        }
    }
    return {};
}

/// Calls as pybind11 does; what it raises is put in better words where a name is wrong.
PyObject* call(PyObject* self, PyObject* arguments, PyObject* named) {
    PyObject* const result = dispatch(self, arguments, named);
    if (result == nullptr && named != nullptr && PyErr_ExceptionMatches(PyExc_TypeError) != 0) {
        if (const std::string words = find_wrong(self, py::reinterpret_borrow<py::dict>(named)); !words.empty()) {
            PyErr_SetString(PyExc_TypeError, words.c_str());
        }
    }
    return result;
}

void take_over(const py::handle& one) {
    const py::object function = py::getattr(one, "__func__", one); // of methods, static ones too
    if (PyCFunction_Check(function.ptr()) == 0 || !py::isinstance<py::capsule>(PyCFunction_GET_SELF(function.ptr()))) {
        return;
    }
    PyCFunction& calls = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml->ml_meth;
    const auto ours = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&call));
    if (calls != ours) { // a function may have two names
        dispatch = reinterpret_cast<PyCFunctionWithKeywords>(reinterpret_cast<void (*)()>(calls));
        calls = ours;
    }
}

} // namespace

void bind_keywords(py::module_& m) {
    m.def("unknown_argument", &unknown_argument);
    for (const auto& [name, one] : m.attr("__dict__").cast<py::dict>()) {
        take_over(one);
        if (py::isinstance<py::type>(one)) {
            for (const auto& [inner, member] : py::dict(one.attr("__dict__"))) {
                take_over(member);
            }
        }
    }
}

} // namespace suffuse::python
