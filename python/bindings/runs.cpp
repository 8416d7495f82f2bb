// Cases that run, from Python: as the verbs run and resume do it, in the same folders, under the same lock.

#include "suffuse/base/byte_size.hpp"
#include "suffuse/base/memory_bound.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/draw_figures.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/job/scene_data.hpp"
#include "suffuse/plan/fit_memory.hpp"
#include "suffuse/plan/requested_stages.hpp"
#include "suffuse/record/checksums.hpp"
#include "suffuse/record/compare_runs.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_sums.hpp"
#include "suffuse/report/page.hpp"

#include <fmt/format.h>

#include "python/bindings/bindings.hpp"
#include "python/bindings/case_handle.hpp"
#include "python/bindings/convert.hpp"
#include "python/bindings/listener.hpp"
#include "python/bindings/own_rule.hpp"
#include "python/bindings/typed.hpp"
#include <functional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace suffuse::python {
namespace {

namespace fs = std::filesystem;

job::RunReport
run_and_listen(const casefile::Case& what, run::RunOptions options, const py::dict& rules, Listener& listener) {
    job::RunReport report;
    Mailbox mailbox;
    for (const auto& [stage, function] : rules) {
        erosion::OwnRule& own = options.rules[stage.cast<std::string>()];
        own = own_rule_of(function, [&](const std::function<void()>& rule) { // by this thread, as on_progress
            mailbox.request_answer([&] { listener.answer(rule); });
        });
        options.command += fmt::format("; {} by the rule {}", stage.cast<std::string>(), own.name);
    }
    options.stop = &listener.stop;
    options.on_progress = [&](const run::Progress& progress) { mailbox.post(progress); };
    listen_while(mailbox, listener, [&] {
        using Kind = job::FolderLock::Kind;
        const bool is_one = !options.sample.empty(); // others work on the other samples
        const job::FolderLock lock(options.folder, warn, is_one ? Kind::Shared : Kind::Alone);
        std::optional<job::FolderLock> own_lock;
        if (is_one) {
            const fs::path own = options.folder / "studies" / options.sample;
            io::make_folders(own);
            own_lock.emplace(own, warn);
        }
        report = job::run_case(what, options);
    });
    return report;
}

/// [B] @throws CaseError
double memory_of(const py::object& memory) {
    if (memory.is_none()) {
        return plan::usual_memory_share * machine_memory();
    }
    if (py::isinstance<py::str>(memory)) {
        return parse_byte_size(memory.cast<std::string>());
    }
    const double bytes = PyFloat_AsDouble(memory.ptr());
    if (PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    if (!(bytes > 0)) {
        throw CaseError(fmt::format("memory: found {}, expected bytes above 0, or a text as \"16GB\"", bytes));
    }
    return bytes;
}

/// Samples that run side by side in the memory that the run may take. A folder that is not there yet holds nothing of
/// the run. @throws IoError where not even one sample does
int samples_within(
    const CaseHandle& what, const py::object& memory, const std::optional<fs::path>& folder, const fs::path& cache,
    const std::string& until
) {
    const casefile::Case& value = what.loaded.value;
    const double bytes = memory_of(memory);
    const Released released;
    plan::MachineSpeed any; // memory does not depend on it, and measuring takes a while
    any.particle_steps_per_second = 1;
    any.at_once = plan::samples_at_once(value);
    plan::RunPlan plan;
    try {
        plan = plan::plan_run(value, any);
    } catch (const CaseError&) { // a sample that cannot be made: the run shows which, and makes the others
        return any.at_once;
    }
    plan::price_requested_alone(plan, value, until, "");
    plan::leave_out_done(plan, value, folder.value_or(fs::path()), record::StageCache(cache));
    return plan::samples_within(plan, bytes);
}

py::tuple conduct(
    const CaseHandle& what, const fs::path& folder, const std::string& until, const py::object& time_limit,
    const fs::path& page_folder, const py::object& on_progress, const fs::path& cache, const py::dict& rules,
    int at_once, const std::string& sample
) {
    plan::check_until(what.loaded.value, until);
    run::RunOptions options;
    options.cache = cache;
    options.folder = folder;
    options.at_once = at_once;
    options.until = until;
    options.page_folder = page_folder;
    options.case_text = what.text;
    options.sample = sample;
    options.command = sample.empty() ? "suffuse.Case.run() in Python" : "suffuse.sweep() in Python";
    options.time_limit = time_limit_of(time_limit).value_or(options.time_limit);
    Listener listener(on_progress);
    const job::RunReport report = run_and_listen(what.loaded.value, std::move(options), rules, listener);
    listener.raise_what_was_raised();
    return py::make_tuple(record::word_of(report.outcome), report.report);
}

/// Samples that the run still needs, those that refine its results so far among them; failed ones, too.
std::vector<std::string> unfinished_samples(const fs::path& folder) {
    const Released released;
    const job::FolderLock lock(folder, warn);
    const std::vector<record::Refinement> refined = record::find_refinements(record::load_run(folder), folder);
    if (!refined.empty()) {
        record::keep_refinements(folder, refined);
    }
    const casefile::Case what = record::load_run(folder);
    std::vector<std::string> names;
    for (const record::Sample& sample : record::list_samples(what)) {
        if (!record::is_complete(sample, folder)) {
            names.push_back(sample.variant->folder);
        }
    }
    return names;
}

/// The report of a run whose samples were run one by one. @return the outcome
std::string gather(const fs::path& folder, const fs::path& page_folder) {
    const Working working;
    const job::FolderLock lock(folder, warn);
    record::require_whole_run(folder);
    io::remove_file(folder / record::provenance_file); // of an earlier gathering, which had fewer samples
    return std::string(record::word_of(job::rebuild_report(folder, page_folder, "suffuse.sweep() in Python").outcome));
}

} // namespace

void bind_runs(py::module_& m) {
    m.def(
        "new_run_folder",
        [](const CaseHandle& what, const std::optional<fs::path>& wanted) {
            fs::path folder;
            if (wanted) {
                folder = *wanted;
                job::take_run_folder(folder);
            } else {
                folder = job::make_run_folder(what.path);
            }
            if (!fs::exists(folder / "run_options.json")) {
                job::save_request(
                    folder, {fs::absolute(what.path).string(),
                             what.options.preset,
                             what.options.overrides,
                             what.options.studies,
                             {}}
                );
            }
            return folder;
        },
        py::arg("case"), py::arg("wanted")
    );
    m.def(
        "samples_within", &samples_within, py::arg("case"), py::arg("memory"), py::arg("folder"), py::arg("cache"),
        py::arg("until")
    );
    m.def("check_until", [](const CaseHandle& what, const std::string& until) {
        plan::check_until(what.loaded.value, until);
    });
    m.def("check_time_limit", [](const py::object& limit) { time_limit_of(limit); });
    m.def("run_request", [](const fs::path& folder) {
        const job::RunRequest request = job::read_request(folder);
        return py::make_tuple(request.case_file, request.preset, request.overrides, request.studies);
    });
    m.def(
        "conduct", &conduct, py::arg("case"), py::arg("folder"), py::arg("until"), py::arg("time_limit"),
        py::arg("page_folder"), py::arg("on_progress"), py::arg("cache"), py::arg("rules"), py::arg("at_once"),
        py::arg("sample") = ""
    );
    m.def("open_run", [](const CaseHandle& what, const fs::path& folder) {
        const job::FolderLock lock(folder, warn);
        record::open_folder(folder, what.loaded.value, what.text);
    });
    m.def("unfinished_samples", &unfinished_samples, py::arg("folder"));
    m.def("gather", &gather, py::arg("folder"), py::arg("page_folder"));
    m.def(
        "read_cbor", [](const fs::path& path) { return to_python(record::read_cbor(path)); }, py::arg("path"),
        "What a stage keeps in results.cbor."
    );
    m.def("draw_figure", [](const fs::path& run, const std::string& which, const fs::path& file, const fs::path& page) {
        const Working working;
        record::require_same_figures(run, {which}, {".vl.json", ".svg"});
        job::draw_figure(run, which, file, page);
    });
    m.def(
        "check_file", &record::check_file, py::arg("path"),
        "Raises IoError where a file of a finished stage is not as the stage left it."
    );
    m.def(
        "check_result", &record::require_same_result, py::arg("run"), py::arg("name"),
        "Raises IoError if a file written by the report has changed since the run ended."
    );
    m.def("scene_page", [](const WorldHandle& w, const std::string& title, const fs::path& page_folder) {
        const SeenWorld world(w);
        return report::scene_page(title, job::scene_of_world(world, title), page_folder);
    });
    m.def("compare_runs", [](const fs::path& first, const fs::path& second, const Quantity& tolerance) {
        const double share = quantity_of(tolerance, dimension::none, "tolerance");
        if (!(share >= 0 && share < 1)) {
            throw UsageError(fmt::format("tolerance: found {}, expected 0 to below 1, as 0.02 or \"2 %\"", share));
        }
        const nlohmann::json found = record::compare_runs(first, second, share);
        return to_python(found);
    });
    m.def("verify_run", [](const fs::path& folder) {
        const nlohmann::json found = record::verify_run(folder);
        return to_python(found);
    });
    m.def("rebuild_report", [](const fs::path& folder, const fs::path& page_folder) {
        const Working working;
        record::check_is_run(folder); // before the lock, which would leave a file there
        const job::FolderLock lock(folder, warn);
        record::require_whole_run(folder);
        return job::rebuild_report(folder, page_folder, "suffuse.Run.rebuild_report() in Python").report;
    });
}

} // namespace suffuse::python
