#pragma once
// Runs from Python: they work on a thread of their own, while this one listens to the user and tells the caller how far
// they are.

#include "suffuse/base/error.hpp"
#include "suffuse/run/run_options.hpp"

#include <fmt/format.h>

#include "python/bindings/convert.hpp"
#include "python/bindings/work.hpp"
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <thread>
#include <utility>

namespace suffuse::python {

/// As a warning of Python's, from whichever thread. One that is to be an error goes to standard error: nothing else is
/// wrong.
inline void warn(const std::string& text) {
    const Holding interpreter;
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) {
        PyErr_WriteUnraisable(Py_None);
    }
}

inline py::dict describe(const run::Progress& progress) {
    py::dict dict;
    dict["study"] = progress.study;
    dict["stage"] = progress.stage;
    dict["verb"] = progress.verb;
    dict["part"] = progress.part;
    dict["stage_number"] = progress.stage_number;
    dict["stages"] = progress.stages;
    dict["steps"] = progress.steps;
    dict["stage_seconds"] = progress.stage_seconds;
    dict["run_seconds"] = progress.run_seconds;
    dict["particle_steps_per_second"] = progress.particle_steps_per_second;
    dict["state"] = to_python(progress.state);
    dict["stage_finished"] = progress.stage_finished;
    dict["from_cache"] = progress.from_cache;
    dict["samples"] = progress.samples;
    dict["sample_ended"] = progress.sample_ended;
    dict["failure"] = progress.failure.empty() ? py::object(py::none()) : py::cast(progress.failure);
    return dict;
}

/// Carries what the run says from its thread to the interpreter's: signals reach that one only.
class Mailbox {
public:
    void post(const run::Progress& progress) {
        const std::lock_guard guard(mutex_);
        letters_.push_back(progress);
    }

    /// Waits until it was answered; what answering throws is thrown here.
    void request_answer(const std::function<void()>& question) {
        std::packaged_task<void()> task(question);
        std::future<void> answer = task.get_future();
        {
            const std::lock_guard guard(mutex_);
            questions_.push_back(std::move(task));
            news_.notify_one();
        }
        answer.get();
    }

    void close() {
        const std::lock_guard guard(mutex_);
        closed_ = true;
        news_.notify_one();
    }

    struct Mail {
        std::deque<run::Progress> letters;
        std::deque<std::packaged_task<void()>> questions; ///< to be called, each of them
        bool closed = false;
    };

    /// What came in, after a tenth of a second, when a question waits, or when the run has ended.
    Mail fetch() {
        std::unique_lock guard(mutex_);
        news_.wait_for(guard, std::chrono::milliseconds(100), [this] { return closed_ || !questions_.empty(); });
        return {std::exchange(letters_, {}), std::exchange(questions_, {}), closed_};
    }

private:
    std::mutex mutex_;
    std::condition_variable news_;
    std::deque<run::Progress> letters_;
    std::deque<std::packaged_task<void()>> questions_;
    bool closed_ = false;
};

/// Ctrl-C, or an exception of a function of the caller's, asks the run to save and stop; it is raised when that is
/// done.
class Listener {
public:
    explicit Listener(py::object on_progress)
        : on_progress_(std::move(on_progress)), has_function_(!on_progress_.is_none()) {}

    void hear(const std::deque<run::Progress>& letters) {
        if (stop) {
            return;
        }
        try {
            look_at_signals()("", 0);
            for (const run::Progress& progress : letters) {
                if (has_function_) {
                    Working::call([&] { call_function(on_progress_, py::make_tuple(describe(progress))); });
                }
            }
        } catch (...) {
            stop_by_what_was_raised();
        }
    }

    /// Calls a rule of the caller's. @throws Interrupted where it raised, or the run is to stop anyway
    void answer(const std::function<void()>& question) {
        if (!stop) {
            try {
                Working::call(question);
                return;
            } catch (...) {
                stop_by_what_was_raised();
            }
        }
        throw Interrupted("a rule was not answered");
    }

    void raise_what_was_raised() const {
        if (raised_) {
            std::rethrow_exception(raised_);
        }
    }

    std::atomic<bool> stop{false};

private:
    void stop_by_what_was_raised() {
        raised_ = std::current_exception();
        stop = true;
    }

    py::object on_progress_;
    bool has_function_;
    std::exception_ptr raised_;
};

/// Does the work on a thread of its own; this one listens to the user meanwhile, and has the turn but while on_progress
/// is called. @throws what the work throws
template <class Work>
void listen_while(Mailbox& mailbox, Listener& listener, Work&& work) {
    std::exception_ptr failure;
    const Working working;
    std::thread worker([&] {
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
        }
        mailbox.close();
    });
    for (bool closed = false; !closed;) {
        Mailbox::Mail mail = mailbox.fetch();
        listener.hear(mail.letters);
        for (std::packaged_task<void()>& question : mail.questions) {
            question();
        }
        closed = mail.closed;
    }
    worker.join();
    if (failure) {
        std::rethrow_exception(failure);
    }
}

/// [s] @throws CaseError as the command line refuses it
inline std::optional<double> time_limit_of(const py::object& given) {
    constexpr double longest = 3.2e9; // [s], a hundred years
    const std::optional<double> limit = optional_quantity(given, dimension::time, "time_limit");
    if (limit && !(*limit > 0)) {
        throw CaseError(
            fmt::format("time_limit: found {} s, which is no time to work in; give one such as \"90 min\"", *limit)
        );
    }
    if (limit && *limit > longest) {
        throw CaseError(
            fmt::format("time_limit: found {:g} s, more than a hundred years; leave it out for none", *limit)
        );
    }
    return limit;
}

} // namespace suffuse::python
