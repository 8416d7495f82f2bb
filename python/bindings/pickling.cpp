// Pickling by any protocol. For protocols 0 and 1 Python asks for an object of the first compiled base class, which is
// pybind11's own and stands for nothing: making one aborts the process. So each class here says itself how it is taken
// apart, as protocol 2 does it, and the base class refuses to make objects.

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"
#include <utility>

namespace suffuse::python {
namespace {

/// An empty object of its class, and the state that is put into it.
py::tuple reduce_any(const py::object& one) {
    const py::type type = py::type::of(one);
    if (!py::hasattr(type, "__setstate__")) {
        throw py::type_error(fmt::format(
            "cannot pickle a suffuse.{}: pickle what it was made from, or its arrays and numbers",
            type.attr("__name__").cast<std::string>()
        ));
    }
    return py::make_tuple(
        py::module_::import("copyreg").attr("__newobj__"), py::make_tuple(type), one.attr("__getstate__")()
    );
}

ternaryfunc make_any = nullptr; ///< pybind11's: makes an object of a class

PyObject* make_object(PyObject* type, PyObject* arguments, PyObject* named) {
    if (type != py::detail::get_internals().instance_base) {
        return make_any(type, arguments, named);
    }
    PyErr_SetString(
        PyExc_TypeError, "pybind11_object makes no objects; to take an object apart, use pickle.dumps or its __reduce__"
    );
    return nullptr;
}

} // namespace

void bind_pickling(py::module_& m) {
    PyTypeObject* const metaclass = py::detail::get_internals().default_metaclass;
    make_any = std::exchange(metaclass->tp_call, &make_object);
    const py::handle of_classes(reinterpret_cast<PyObject*>(metaclass));
    for (const auto& [name, one] : m.attr("__dict__").cast<py::dict>()) {
        if (py::isinstance(one, of_classes) && !one.attr("__dict__").contains("__reduce__")) {
            py::setattr(one, "__reduce__", py::cpp_function(&reduce_any, py::name("__reduce__"), py::is_method(one)));
        }
    }
}

} // namespace suffuse::python
