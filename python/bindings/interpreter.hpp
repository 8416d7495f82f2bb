#pragma once
// Leaving the interpreter to other threads while C++ computes, and coming back to it. CPython ends a thread that comes
// back while the interpreter ends; that would unwind C++ in the middle of its work and abort the program. So at the end
// of the interpreter (an atexit function) work of other threads is interrupted, and they wait forever where they would
// come back, as they do since Python 3.14.

#include <optional>
#include <pybind11/pybind11.h>

namespace suffuse::python {

/// While it lives, other threads may use the interpreter. Made and ended by a thread that holds it.
class Released {
public:
    Released();

    /// Does not return where the interpreter has ended meanwhile.
    ~Released();

    Released(const Released&) = delete;
    Released& operator=(const Released&) = delete;

private:
    std::optional<pybind11::gil_scoped_release> released_;
};

/// While it lives, this thread holds the interpreter again, within Released or on a thread of the library's own.
class Holding {
public:
    /// @throws Interrupted where the interpreter ends: the work has to end, too
    Holding() = default;

private:
    struct Permit {
        Permit();
    };

    Permit permit_;
    pybind11::gil_scoped_acquire held_;
};

/// Calls a function of the caller's with the interpreter held, which may take long or never return.
pybind11::object call_function(pybind11::handle function, const pybind11::tuple& arguments);

/// Has the end of the interpreter wait for the work of other threads.
void watch_end_of_interpreter();

} // namespace suffuse::python
