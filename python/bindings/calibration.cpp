// Calibrations from Python: as the verb does it, in the same folders, under the same lock.

#include "suffuse/base/stopwatch.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/calibrate.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/job/verify_calibration.hpp"
#include "suffuse/record/folder.hpp"

#include "python/bindings/bindings.hpp"
#include "python/bindings/listener.hpp"
#include "python/bindings/warn_caller.hpp"
#include <limits>
#include <pybind11/stl/filesystem.h>

namespace suffuse::python {
namespace {

namespace fs = std::filesystem;

/// Where it works: a new folder unless one is wanted.
fs::path folder_of(const fs::path& case_file, const std::optional<fs::path>& wanted) {
    if (!wanted) {
        return job::make_run_folder(case_file);
    }
    job::take_run_folder(*wanted);
    return *wanted;
}

/// What is left of a round. @return false where it was stopped
bool run_round(const job::CalibrationRound& round, run::RunOptions options) {
    options.case_text = casefile::resolved_toml(round.samples);
    record::open_folder(round.folder, round.samples, options.case_text);
    if (job::is_round_done(round)) {
        return true;
    }
    options.folder = round.folder;
    return job::run_without_report(round.samples, options);
}

/// @return its folder, and calibration.json: none where it was stopped before its first round ended
py::tuple calibrate(
    const fs::path& case_file, const std::vector<std::string>& overrides, const std::optional<fs::path>& wanted,
    const py::object& time_limit, const py::object& on_progress, const fs::path& cache
) {
    const double limit = time_limit_of(time_limit).value_or(std::numeric_limits<double>::infinity());
    const casefile::CalibrationCase what = casefile::load_calibration(case_file.string(), {{}, overrides, {}});
    job::first_round(what); // errors leave no folder
    for (const Diagnostic& warning : job::warnings_of_records(what)) {
        warn_caller(warning.message, 3); // suffuse.calibrate and its wrapper are above it
    }
    const fs::path folder = folder_of(case_file, wanted);
    job::keep_calibration_case(case_file.string(), what, folder);
    job::save_request(folder, {fs::absolute(case_file).string(), "", overrides, {}, cache.string()});
    run::RunOptions options;
    options.cache = cache;
    options.command = "suffuse.calibrate() in Python";
    Mailbox mailbox;
    Listener listener(on_progress);
    options.stop = &listener.stop;
    options.on_progress = [&](const run::Progress& progress) { mailbox.post(progress); };
    job::CalibrationResult result;
    listen_while(mailbox, listener, [&] {
        const job::FolderLock lock(folder, warn);
        const Stopwatch watch;
        const auto run = [&](const job::CalibrationRound& round) {
            options.time_limit = limit - watch.seconds();
            return run_round(round, options);
        };
        result = job::calibrate(what, {folder, run});
        io::remove_file(folder / record::checksums_file); // true no more
        record::keep_provenance(folder, job::first_round(what), options.command, watch.seconds());
        if (!result.parameters.empty()) {
            job::write_calibration(folder, what, result);
        }
        if (result.is_complete) {
            job::write_calibration_sums(folder);
        }
    });
    listener.raise_what_was_raised();
    return py::make_tuple(
        folder, result.parameters.empty() ? py::object(py::none()) : to_python(job::calibration_json(what, result))
    );
}

} // namespace

void bind_calibration(py::module_& m) {
    m.def(
        "calibrate", &calibrate, py::arg("case"), py::arg("overrides"), py::arg("wanted"), py::arg("time_limit"),
        py::arg("on_progress"), py::arg("cache")
    );
    m.def("verify_calibration", [](const fs::path& folder) {
        const nlohmann::json found = job::verify_calibration(folder);
        return to_python(found);
    });
}

} // namespace suffuse::python
