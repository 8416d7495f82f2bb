#pragma once
// Long work from Python: the interpreter is released, one call steps at a time (two would halve each other's threads),
// and Ctrl-C or an exception of the caller's progress function ends it between two bursts of steps. The turn is the
// calling thread's: what its on_progress calls may step other worlds. What only reads takes no turn.

#include "suffuse/base/pulse.hpp"

#include "python/bindings/world_handle.hpp"
#include <chrono>
#include <mutex>
#include <optional>
#include <pybind11/pybind11.h>
#include <string_view>

namespace suffuse::python {

/// While it lives, this thread alone steps worlds, and the interpreter is released. What it calls may step others.
class Working {
public:
    /// Waits until no other thread steps. @throws pybind11::error_already_set: KeyboardInterrupt meanwhile
    Working() {
        while (!turn_.try_lock_for(std::chrono::milliseconds(100))) {
            const pybind11::gil_scoped_acquire interpreter;
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
        }
    }

private:
    static std::recursive_timed_mutex& mutex() {
        static std::recursive_timed_mutex one;
        return one;
    }

    pybind11::gil_scoped_release released_; // first: another thread that computes may want the interpreter
    std::unique_lock<std::recursive_timed_mutex> turn_{mutex(), std::defer_lock};
};

/// For long work that has nothing to tell: ends it at Ctrl-C.
inline Pulse look_at_signals() {
    return [](std::string_view, long long) {
        const pybind11::gil_scoped_acquire interpreter;
        if (PyErr_CheckSignals() != 0) {
            throw pybind11::error_already_set();
        }
    };
}

/// Looks at Ctrl-C and tells the caller how far the work is, at most ten times a second.
class Attention {
public:
    Attention(pybind11::object on_progress, Stepping& call) : on_progress_(std::move(on_progress)), call_(call) {}

    /// Called between bursts while Working. @throws pybind11::error_already_set: KeyboardInterrupt, or what the
    /// caller's function raised.
    void beat(std::string_view part, long long steps) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) {
            return;
        }
        last_ = now;
        const pybind11::gil_scoped_acquire interpreter;
        const Stepping::Pause pause(call_);
        if (PyErr_CheckSignals() != 0) {
            throw pybind11::error_already_set();
        }
        if (!on_progress_.is_none()) {
            on_progress_(part, steps);
        }
    }

private:
    pybind11::object on_progress_;
    Stepping& call_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace suffuse::python
