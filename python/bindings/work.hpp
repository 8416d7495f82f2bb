#pragma once
// Long work from Python: the interpreter is released, one call steps at a time (two would halve each other's threads),
// and Ctrl-C or an exception of the caller's progress function ends it between two bursts of steps. While a function of
// the caller's runs, the turn is free: what it calls, or waits for in another thread, may step other worlds. What only
// reads takes no turn.

#include "suffuse/base/interruption.hpp"
#include "suffuse/base/pulse.hpp"

#include "python/bindings/interpreter.hpp"
#include "python/bindings/world_handle.hpp"
#include <chrono>
#include <mutex>
#include <optional>
#include <pybind11/pybind11.h>
#include <string_view>
#include <utility>

namespace suffuse::python {

/// While it lives, this thread alone steps worlds, and the interpreter is released.
class Working {
public:
    /// Waits until no other thread steps. @throws pybind11::error_already_set: KeyboardInterrupt meanwhile
    Working() {
        take_turn();
        innermost() = this;
    }

    ~Working() { innermost() = outer_; }

    Working(const Working&) = delete;
    Working& operator=(const Working&) = delete;

    /// Calls a function of the caller's with the interpreter held; others may step meanwhile.
    /// @throws pybind11::error_already_set: what it raised, or KeyboardInterrupt while others step on
    template <class Function>
    static void call(Function&& function) {
        Working* const work = std::exchange(innermost(), nullptr);
        if (work != nullptr && work->turn_.owns_lock()) {
            work->turn_.unlock();
        }
        const Resumed resumed{work};
        {
            const Holding interpreter;
            function();
        }
        if (work != nullptr) {
            work->take_turn();
        }
    }

private:
    struct Resumed {
        Working* work;

        ~Resumed() { innermost() = work; }
    };

    static Working*& innermost() {
        thread_local Working* one = nullptr;
        return one;
    }

    static std::timed_mutex& mutex() {
        static std::timed_mutex one;
        return one;
    }

    void take_turn() {
        while (!turn_.try_lock_for(std::chrono::milliseconds(100))) {
            const Holding interpreter;
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
        }
    }

    Working* outer_ = innermost();
    Released released_; // first: another thread that computes may want the interpreter
    std::unique_lock<std::timed_mutex> turn_{mutex(), std::defer_lock};
};

/// For long work that has nothing to report: ends it at Ctrl-C.
inline Pulse look_at_signals() {
    return [](std::string_view, long long) {
        const Holding interpreter;
        if (PyErr_CheckSignals() != 0) {
            throw pybind11::error_already_set();
        }
    };
}

/// While it lives, the interpreter is released, and Ctrl-C ends what this thread computes: work that changes nothing.
class Computing {
public:
    Computing()
        : interruption_([last = std::chrono::steady_clock::now()]() mutable {
              const auto now = std::chrono::steady_clock::now();
              if (now - last >= std::chrono::milliseconds(50)) {
                  last = now;
                  look_at_signals()("", 0);
              }
          }) {}

private:
    Released released_;
    Interruption interruption_;
};

/// Looks at Ctrl-C and tells the caller how far the work is, at most ten times a second.
class Attention {
public:
    Attention(pybind11::object on_progress, Stepping& call)
        : on_progress_(std::move(on_progress)), has_function_(!on_progress_.is_none()), call_(call) {}

    /// Called between bursts while Working. @throws pybind11::error_already_set: KeyboardInterrupt, or what the
    /// caller's function raised.
    void beat(std::string_view part, long long steps) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(100)) {
            return;
        }
        last_ = now;
        if (!has_function_) {
            const Holding interpreter;
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
            return;
        }
        Working::call([&] {
            const Stepping::Pause pause(call_);
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
            call_function(on_progress_, pybind11::make_tuple(part, steps));
        });
    }

private:
    pybind11::object on_progress_;
    bool has_function_;
    Stepping& call_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

} // namespace suffuse::python
