#include "python/bindings/interpreter.hpp"

#include "suffuse/base/error.hpp"

#include <atomic>
#include <chrono>
#include <cxxabi.h>
#include <thread>
#include <unistd.h>

namespace suffuse::python {
namespace {

namespace py = pybind11;

// A thread counts itself before it looks whether the end has begun, and the end begins before it counts: one of the two
// sees the other.
std::atomic<int> away = 0;    ///< threads within Released that are to come back
std::atomic<int> calling = 0; ///< of those, within a function of the caller's
std::atomic<bool> ends = false;
std::atomic<std::thread::id> ending_thread; ///< may still use the interpreter

bool is_over_for_this_thread() {
    return ends && ending_thread.load() != std::this_thread::get_id();
}

[[noreturn]] void wait_forever() {
    for (;;) {
        ::pause();
    }
}

/// Until all have come to where they wait, or the user has had enough. A function of the caller's may wait for what
/// never comes: such a thread is left behind.
void end_other_work() {
    ending_thread = std::this_thread::get_id();
    ends = true;
    constexpr std::chrono::milliseconds patience = std::chrono::seconds(5), interval(10);
    for (std::chrono::milliseconds waited(0); away > (waited < patience ? 0 : calling.load()); waited += interval) {
        {
            const py::gil_scoped_release released;
            std::this_thread::sleep_for(interval);
        }
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
    }
}

struct Calling {
    Calling() { ++calling; }

    ~Calling() { --calling; }

    Calling(const Calling&) = delete;
    Calling& operator=(const Calling&) = delete;
};

} // namespace

Released::Released() {
    const bool is_over = is_over_for_this_thread();
    away += is_over ? 0 : 1;
    released_.emplace();
    if (is_over) {
        wait_forever();
    }
}

Released::~Released() {
    if (is_over_for_this_thread()) {
        --away;
        wait_forever();
    }
    released_.reset();
    --away;
}

Holding::Permit::Permit() {
    if (is_over_for_this_thread()) {
        throw Interrupted("the Python interpreter ends");
    }
}

py::object call_function(py::handle function, const py::tuple& arguments) {
    const Calling here;
    PyObject* result = nullptr;
    try {
        result = PyObject_Call(function.ptr(), arguments.ptr(), nullptr);
    } catch (const abi::__forced_unwind&) { // the interpreter has ended meanwhile; nothing of ours is unwound yet
        wait_forever();
    }
    if (result == nullptr) {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::object>(result);
}

void watch_end_of_interpreter() {
    py::module_::import("atexit").attr("register")(py::cpp_function(&end_other_work));
    py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function([] {
                                                           away = calling = 0; // their threads are not in this process
                                                       }));
}

} // namespace suffuse::python
