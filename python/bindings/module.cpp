// suffuse._core: see bindings.hpp.

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/version.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/interpreter.hpp"
#include <algorithm>
#include <thread>

PYBIND11_MODULE(_core, m) {
    namespace py = pybind11;
    using namespace suffuse;

    m.doc() = "The compiled half of suffuse; import suffuse instead.";
    m.attr("__module__") = "suffuse"; // of all that follows: where users, and pickle, find it
    python::watch_end_of_interpreter();
    m.attr("__version__") = version();
    m.def("commit", &commit, "Short hash of the source that this module was built from.");
    m.def("compiler", &compiler);
    m.def("threads", &thread_count, "Number of threads that long work uses.");
    m.def(
        "set_threads",
        [](int threads) {
            constexpr int most = 1024; // as of the command line
            if (threads < 0 || threads > most) {
                throw CaseError(
                    "threads: found " + std::to_string(threads) + ", expected 1 to " + std::to_string(most) +
                    ", or 0: one for each core"
                );
            }
            const python::Released released;
            const int cores = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
            set_thread_count(threads > 0 ? threads : cores);
        },
        py::arg("threads") = 0, "Sets the number of threads; 0: one for each core. Results do not depend on it."
    );
    python::bind_errors(m);
    python::bind_settings(m);
    python::bind_contacts(m);
    python::bind_world(m);
    python::bind_steps(m);
    python::bind_laboratory_tests(m);
    python::bind_preparation(m);
    python::bind_pores(m);
    python::bind_water(m);
    python::bind_mobility(m);
    python::bind_migration(m);
    python::bind_own_rule(m);
    python::bind_erosion(m);
    python::bind_resolved(m);
    python::bind_files(m);
    python::bind_laboratory(m);
    python::bind_calibration(m);
    python::bind_stability(m);
    python::bind_cases(m);
    python::bind_runs(m);
    python::bind_pickling(m);
    python::bind_keywords(m);
    set_thread_count(std::max(static_cast<int>(std::thread::hardware_concurrency()), 1));
}
