// run, resume, report: the job.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/job/ended_run.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/asked_stages.hpp"
#include "suffuse/plan/plan_record.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/live_report.hpp"
#include "apps/page_folder.hpp"
#include "apps/progress_file.hpp"
#include "apps/run_ending.hpp"
#include "apps/stop_signal.hpp"
#include "apps/terminal.hpp"
#include "apps/test_gate.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <unistd.h>
#include <utility>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

/// A run that is about to begin or to go on.
struct Job {
    casefile::Case what;
    fs::path folder;
    std::string case_text;
    fs::path cache; ///< empty: none
    plan::RunPlan plan;
};

double limit_of(const std::string& text) {
    if (text.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    const double limit = quantity_of(text, dimension::time, "--time-limit", false);
    if (!(limit > 0)) {
        throw UsageError(fmt::format("--time-limit {} is no time to work in", shown(text)));
    }
    return limit;
}

/// Folder of the sample that is asked for alone. @throws UsageError where there is no such sample.
std::optional<fs::path> check_sample(const casefile::Case& what, const fs::path& folder, const std::string& name) {
    if (name.empty()) {
        return std::nullopt;
    }
    std::vector<std::string> names;
    for (const record::Sample& sample : record::list_samples(what)) {
        names.push_back(sample.variant->folder);
    }
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        throw UsageError(fmt::format(
            "--sample {}: the run has no such sample{}; suffuse plan lists them", shown(name), near_hint(name, names)
        ));
    }
    fs::create_directories(folder / "studies" / name);
    return folder / "studies" / name;
}

/// The plan without what the folder or the cache holds, what comes after the stage asked for as the last, and other
/// samples than the one asked for alone.
plan::RunPlan plan_rest(
    const casefile::Case& what, const fs::path& folder, const fs::path& cache, const std::string& until,
    const std::string& only = {}
) {
    plan::RunPlan plan = plan::plan_case(what, only.empty() ? plan::samples_at_once(what) : 1);
    plan::price_asked_alone(plan, what, until, only);
    plan::leave_out_done(plan, what, folder, record::StageCache(cache));
    return plan;
}

/// The plan of what is asked for alone.
plan::RunPlan asked_plan(const Job& job, const CommandLine& line) {
    plan::RunPlan plan = job.plan;
    plan::keep_asked_alone(plan, job.what, line.until, line.sample);
    return plan;
}

Screen standard_error(const Console& console) {
    return {can_redraw(), speaks_utf8(), console.is_quiet(), terminal_width, [](const std::string& text) {
                if (takes_words(STDERR_FILENO)) { // the run waits for no terminal
                    std::fwrite(text.data(), 1, text.size(), stderr);
                }
            }};
}

/// The run, and the last live page where no report takes its place.
job::RunReport run_to_its_end(const Job& job, const run::RunOptions& options, std::optional<LiveReport>& live) {
    const auto close = [&](const std::string& ending) {
        if (live) {
            live->close(ending);
        }
    };
    try {
        job::RunReport report = job::run_case(job.what, options);
        if (record::is_resumable(report.outcome)) {
            close(fmt::format("The run ended early: {}.", record::word_of(report.outcome)));
        }
        return report;
    } catch (const std::exception& error) {
        close(fmt::format("The run failed: {}", error.what()));
        throw;
    }
}

run::RunOptions options_of(const Job& job, const CommandLine& line) {
    run::RunOptions options;
    options.folder = job.folder;
    options.until = line.until;
    options.sample = line.sample;
    options.time_limit = limit_of(line.time_limit);
    options.stop = &stop_flag();
    options.cache = job.cache;
    options.page_folder = page_folder();
    options.case_text = job.case_text;
    options.command = line.typed;
    options.is_checked = true;
    return options;
}

int tell_untouched(const job::RunReport& report, const Job& job, const Console& console) {
    const std::string word(record::word_of(report.outcome));
    tell_results(report, word + " before; nothing to do", console);
    const int code = exit_code_of(report);
    console.document(json_text(
        {{"outcome", word},
         {"exit_code", code},
         {"folder", job.folder.string()},
         {"report", report.report.string()},
         {"wall_seconds", 0.0},
         {"warnings", report.warnings},
         {"flaws", report.flaws},
         {"failures", report.failures},
         {"findings", report.findings}}
    ));
    return code;
}

/// The code of a run that needs nothing. What is damaged is told before anything is written.
std::optional<int> look_before(const Job& job, const CommandLine& line, const Console& console) {
    const std::string unchecked = record::tell_unchecked(record::require_whole_run(job.folder, line.sample));
    if (!unchecked.empty()) {
        console.talk("warning: " + unchecked);
    }
    const std::optional<job::RunReport> ended = job::find_ended(job.what, options_of(job, line));
    return ended ? std::optional(tell_untouched(*ended, job, console)) : std::nullopt;
}

int conduct(const Job& job, const CommandLine& line, const Console& console) {
    run::RunOptions options = options_of(job, line);
    ProgressView view(
        standard_error(console), job.plan, "Ctrl-C saves and stops; suffuse resume " + shell_word(job.folder.string())
    );
    ProgressFile published(line.sample.empty() ? job.folder : job.folder / "studies" / line.sample, job.plan);
    std::optional<LiveReport> live;
    if (line.sample.empty()) {
        live.emplace(job.folder, job.what.title, "suffuse resume " + shell_word(job.folder.string()), job.plan);
    }
    TestGate gate;
    if (gate.is_set()) {
        options.progress_interval = 0;
    }
    bool told_stop = false;
    options.on_progress = [&](const run::Progress& progress) {
        if (stop_flag() && !std::exchange(told_stop, true)) {
            view.begin_anew();
        } // the signal's message stands below
        view.show(progress);
        published.show(progress);
        if (live) {
            live->show(progress);
        }
        gate.pass(progress);
    };
    if (line.sample.empty()) { // a sample beside others knows the price of its own stages only
        plan::keep_plan(job.folder, job.plan);
    }
    const Stopwatch watch;
    const job::RunReport report = run_to_its_end(job, options, live);
    view.clear();
    for (const std::string& remark : report.remarks) {
        console.talk("warning: " + remark);
    }
    const double seconds = watch.seconds();
    const bool was_done = std::ranges::all_of(asked_plan(job, line).stages, &plan::StageEstimate::is_done);
    return tell_end(
        {job.folder, line.sample, std::ssize(record::list_samples(job.what)), seconds, was_done}, report, console
    );
}

void tell_plan(const Job& job, const CommandLine& line, const std::string& verb, const Console& console) {
    const plan::RunPlan asked = asked_plan(job, line);
    console.talk(fmt::format(
        "case  {}   preset {}   seed {}   {}{}", job.what.title.empty() ? "without a title" : job.what.title,
        job.what.preset, job.what.seed, plural(thread_count(), "thread"),
        job.plan.speed.at_once > 1 ? fmt::format("   {} samples at once", job.plan.speed.at_once) : ""
    ));
    console.talk(fmt::format("plan  {}", plan::plan_sentence(asked)));
    console.talk(fmt::format("{:5} {}   report.html there shows how far it is", verb, job.folder.string()));
    const auto cached =
        std::count_if(asked.stages.begin(), asked.stages.end(), [](const auto& stage) { return stage.is_cached; });
    if (cached > 0) {
        console.talk(fmt::format(
            "cache {}   holds {} of the {}; --no-cache computes all", job.cache.string(), cached,
            plural(std::ssize(job.plan.stages), "stage")
        ));
    }
}

/// "--preset standard (20-40 min)" after a quick run. The case is read anew for it, and what it holds by then, or
/// says of that preset, must not turn a run that succeeded into a failure: nothing where it has errors.
std::string larger_hint(const CommandLine& line, const Job& job) {
    if (job.what.preset != "quick") {
        return "";
    }
    try {
        const casefile::Case larger =
            casefile::load_case(line.subject, {"standard", line.overrides, line.studies}).value;
        return fmt::format(
            "--preset standard ({})", duration_range_text(plan::plan_run(larger, job.plan.speed).seconds)
        );
    } catch (const Error&) {
        return "";
    }
}

} // namespace

int run_verb(const CommandLine& line, const Console& console) {
    limit_of(line.time_limit); // wrong use is told before anything is made
    heed_signals();
    Job job;
    job.what = load_asked_case(line, console);
    plan::check_until(job.what, line.until);
    job.case_text = read_whole_file(line.subject);
    set_threads(line.threads);
    job.cache = cache_folder(line, job::cache_beside(line.output.empty() ? "runs/new" : line.output));
    job.folder = line.output;
    job.plan = plan_rest(job.what, job.folder, job.cache, line.until); // where it throws no folder is left
    if (line.output.empty()) {
        job.folder = job::make_run_folder(line.subject);
    } else {
        job::take_run_folder(job.folder);
    }
    const job::FolderLock lock(job.folder, console.warner());
    if (!fs::exists(job.folder / "run_options.json")) {
        const bool is_asked = line.no_cache || !line.cache.empty();
        job::keep_asked(
            job.folder, {fs::absolute(line.subject).string(), line.preset, line.overrides, line.studies,
                         is_asked ? std::optional(job.cache.string()) : std::nullopt}
        );
    }
    record::open_folder(job.folder, job.what, job.case_text); // another case's is refused before the plan is told
    if (const std::optional<int> code = look_before(job, line, console)) {
        return *code;
    }
    tell_plan(job, line, "into", console);
    const int code = conduct(job, line, console);
    if (code == Done) {
        std::vector<std::string> hints;
        if (std::string larger = larger_hint(line, job); !larger.empty()) {
            hints.push_back(std::move(larger));
        }
        if (!job.what.paper.empty()) { // an example
            hints.emplace_back("a soil of yours, suffuse new --psd FILE");
        }
        if (!hints.empty()) {
            console.talk(fmt::format("next: {}", fmt::join(hints, "; ")));
        }
    }
    return code;
}

int resume_verb(const CommandLine& line, const Console& console) {
    limit_of(line.time_limit);
    heed_signals();
    const fs::path folder = line.subject;
    const fs::path resolved = folder / record::resolved_case_file;
    Job job;
    job.folder = folder;
    fs::path usual_cache = job::cache_beside(folder);
    if (fs::exists(folder / "run_options.json")) {
        usual_cache = job::read_asked(folder).cache.value_or(usual_cache.string());
    }
    job.cache = cache_folder(line, usual_cache);
    if (fs::exists(resolved)) {
        job.what = record::load_run(folder);
    } else { // stopped before it really began
        const job::AskedRun asked = job::read_asked(folder);
        job.what = casefile::load_case(asked.case_file, {asked.preset, asked.overrides, asked.studies}).value;
        job.case_text = read_whole_file(asked.case_file);
    }
    plan::check_until(job.what, line.until);
    set_threads(line.threads);
    const auto own = check_sample(job.what, folder, line.sample);
    const job::FolderLock lock(
        folder, console.warner(), own ? job::FolderLock::Kind::Shared : job::FolderLock::Kind::Alone
    );
    const std::optional<job::FolderLock> own_lock =
        own ? std::optional<job::FolderLock>(std::in_place, *own, console.warner()) : std::nullopt;
    if (const std::optional<int> code = look_before(job, line, console)) {
        return *code;
    }
    job.plan = plan_rest(job.what, folder, job.cache, line.until, line.sample);
    tell_plan(job, line, "in", console);
    return conduct(job, line, console);
}

int report_verb(const CommandLine& line, const Console& console) {
    const fs::path folder = line.subject;
    record::check_is_run(folder); // before the lock, which would leave a file there
    const job::FolderLock lock(folder, console.warner());
    const std::string unchecked = record::tell_unchecked(record::require_whole_run(folder));
    if (!unchecked.empty()) {
        console.talk("warning: " + unchecked);
    }
    const job::RunReport report = job::rebuild_report(folder, page_folder(), line.typed);
    tell_results(report, "written", console);
    console.document(json_text(
        {{"report", report.report.string()},
         {"warnings", report.warnings},
         {"flaws", report.flaws},
         {"findings", report.findings}}
    ));
    return exit_code_of(report);
}

} // namespace suffuse::apps
