// Every error of the library as a Python exception with the same text; its numbers are attributes.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/readable.hpp"
#include "suffuse/base/units.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/convert.hpp"

namespace suffuse::python {
namespace {

/// The exception classes; they live as long as the process.
struct Classes {
    PyObject *error, *bad_case, *problems, *geometry, *solver, *state, *io, *interrupted, *unit, *usage, *bug;
};

Classes classes;

PyObject* make(py::module_& m, const char* name, const char* doc, const std::vector<PyObject*>& bases) {
    py::tuple parents(bases.size());
    for (std::size_t k = 0; k < bases.size(); ++k) {
        parents[k] = py::reinterpret_borrow<py::object>(bases[k]);
    }
    const std::string full = std::string("suffuse.") + name;
    PyObject* made = PyErr_NewExceptionWithDoc(full.c_str(), doc, parents.ptr(), nullptr);
    if (made == nullptr) {
        throw py::error_already_set();
    }
    m.attr(name) = py::reinterpret_borrow<py::object>(made);
    return made;
}

/// Names of files may hold bytes that are no text: a question mark for each, or the message itself would be an error.
py::object text(const std::string& value) {
    return py::str(as_utf8(value));
}

template <class... Attribute>
void raise(PyObject* kind, const char* message, const Attribute&... attribute) {
    const auto type = py::reinterpret_borrow<py::object>(kind);
    py::object exception = type(text(readable(message)));
    (py::setattr(exception, attribute.first, attribute.second), ...);
    PyErr_SetObject(kind, exception.ptr());
}

void translate(std::exception_ptr thrown) {
    using Field = std::pair<const char*, py::object>;
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const CaseProblems& error) {
        py::list problems;
        for (const Diagnostic& problem : error.problems) {
            problems.append(py::cast(problem));
        }
        raise(
            classes.problems, error.what(), Field{"problems", problems}, Field{"file", text(error.file)},
            Field{"line", py::int_(error.line)}
        );
    } catch (const CaseError& error) {
        raise(classes.bad_case, error.what(), Field{"file", text(error.file)}, Field{"line", py::int_(error.line)});
    } catch (const UnitError& error) {
        raise(classes.unit, error.what(), Field{"help", text(readable(error.help))});
    } catch (const GeometryError& error) {
        raise(classes.geometry, error.what());
    } catch (const SolverError& error) {
        raise(
            classes.solver, error.what(), Field{"iterations", py::int_(error.iterations)},
            Field{"residual", py::float_(error.residual)}
        );
    } catch (const StateError& error) {
        raise(classes.state, error.what());
    } catch (const IoError& error) {
        raise(classes.io, error.what());
    } catch (const Interrupted& error) {
        raise(classes.interrupted, error.what());
    } catch (const UsageError& error) {
        raise(classes.usage, error.what());
    } catch (const Error& error) {
        raise(classes.error, error.what());
    } catch (const Bug& error) {
        raise(classes.bug, error.what());
    }
}

} // namespace

void bind_errors(py::module_& m) {
    classes.error = make(m, "Error", "Anything that the user or the machine can mend.", {PyExc_Exception});
    classes.bad_case = make(
        m, "CaseError", "A case, a data file or an argument is invalid: `file`, `line`.",
        {classes.error, PyExc_ValueError}
    );
    classes.problems = make(m, "CaseProblems", "All that is wrong with a case: `problems`.", {classes.bad_case});
    classes.unit = make(m, "UnitError", "A text that is no quantity, or the wrong one.", {classes.bad_case});
    classes.usage = make(m, "UsageError", "Wrong use, such as a folder that is taken.", {classes.bad_case});
    classes.geometry = make(m, "GeometryError", "Geometry that the method cannot treat.", {classes.error});
    classes.solver =
        make(m, "SolverError", "A linear solver missed its tolerance: `iterations`, `residual`.", {classes.error});
    classes.state = make(m, "StateError", "The state left what the model can describe.", {classes.error});
    classes.io = make(m, "IoError", "A file that cannot be read or written.", {classes.error, PyExc_OSError});
    classes.interrupted = make(m, "Interrupted", "Long work was interrupted on request.", {classes.error});
    classes.bug = make(m, "Bug", "A defect of suffuse; please report it.", {PyExc_RuntimeError});
    py::register_exception_translator(&translate);
}

} // namespace suffuse::python
