#include "apps/conduct_job.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/memory_bound.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/job/ended_run.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/plan/fit_memory.hpp"
#include "suffuse/plan/past_prices.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/plan/plan_record.hpp"
#include "suffuse/plan/requested_stages.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

#include "apps/json_text.hpp"
#include "apps/live_report.hpp"
#include "apps/page_folder.hpp"
#include "apps/progress_file.hpp"
#include "apps/run_ending.hpp"
#include "apps/shortages.hpp"
#include "apps/stop_signal.hpp"
#include "apps/terminal.hpp"
#include "apps/test_gate.hpp"
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <unistd.h>
#include <utility>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

constexpr double stack_of_threads = 16e6; // [B] a thread, and one that waits for it: counted in the bound, rarely used

/// The plan of what is requested only.
plan::RunPlan requested_plan(const Job& job) {
    plan::RunPlan plan = job.plan;
    plan::keep_requested_alone(plan, job.what, job.until, job.sample);
    return plan;
}

Screen standard_error(const Console& console) {
    return {can_redraw(), supports_utf8(), console.is_quiet(), terminal_width, [](const std::string& text) {
                if (takes_words(STDERR_FILENO)) { // the run waits for no terminal
                    std::fwrite(text.data(), 1, text.size(), stderr);
                }
            }};
}

/// Those who show a run while it is under way: the terminal, progress.json and the live page.
class Watchers {
public:
    /// @param page folder of the live page; empty: none
    Watchers(const Job& job, const Console& console, const fs::path& page)
        : view_(
              standard_error(console), job.plan,
              "Ctrl-C saves and stops; suffuse resume " + shell_word(job.folder.string())
          ),
          published_(job.sample.empty() ? job.folder : job.folder / "studies" / job.sample, job.plan) {
        if (!page.empty()) {
            live_.emplace(page, job.what.title, "suffuse resume " + shell_word(page.string()), job.plan);
        }
    }

    /// They see what the run with these options reports, as long as they live.
    void attach(run::RunOptions& options) {
        if (gate_.is_set()) {
            options.progress_interval = 0;
        }
        options.on_progress = [this](const run::Progress& progress) {
            if (stop_flag() && !std::exchange(has_reported_stop_, true)) {
                view_.begin_anew();
            } // the signal's message stands below
            view_.show(progress);
            published_.show(progress);
            if (live_) {
                live_->show(progress);
            }
            gate_.pass(progress);
        };
    }

    void clear() { view_.clear(); }

    [[nodiscard]] std::optional<LiveReport>& live() { return live_; }

private:
    ProgressView view_;
    ProgressFile published_;
    std::optional<LiveReport> live_;
    TestGate gate_;
    bool has_reported_stop_ = false;
};

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

run::RunOptions options_of(const Job& job) {
    run::RunOptions options;
    options.folder = job.folder;
    options.until = job.until;
    options.sample = job.sample;
    options.time_limit = job.time_limit;
    options.stop = &stop_flag();
    options.cache = job.cache;
    options.cache_owners = job.cache_owners;
    options.at_once = job.plan.speed.at_once;
    options.page_folder = page_folder();
    options.case_text = job.case_text;
    options.command = job.command;
    options.is_checked = true;
    return options;
}

int report_untouched(const job::RunReport& report, const Job& job, const Console& console) {
    const std::string word(record::word_of(report.outcome));
    print_results(report, word + " before; nothing to do", console);
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

} // namespace

plan::RunPlan plan_rest(const Job& job) {
    return plan::plan_within(job.memory, job.sample.empty() ? plan::samples_at_once(job.what) : 1, [&](int at_once) {
        const plan::MachineSpeed& known = job.plan.speed; // measured for an earlier sample of this call
        const bool is_known = known.particle_steps_per_second > 0 && known.at_once == at_once;
        plan::RunPlan plan = is_known ? plan::plan_run(job.what, known) : plan::plan_case(job.what, at_once);
        plan::PastPrices(job.cache).correct(plan);
        plan::price_requested_alone(plan, job.what, job.until, job.sample);
        plan::leave_out_done(plan, job.what, job.folder, record::StageCache(job.cache, job.cache_owners));
        return plan;
    });
}

std::optional<int> look_before(const Job& job, const Console& console) {
    const std::string doubts = record::require_whole_run(job.folder, job.sample);
    record::require_same_imports(job.what, job.folder, job.sample);
    if (!doubts.empty()) {
        console.talk("warning: " + doubts);
    }
    const std::optional<job::RunReport> ended = job::find_ended(job.what, options_of(job));
    return ended ? std::optional(report_untouched(*ended, job, console)) : std::nullopt;
}

int conduct(const Job& job, const Console& console) {
    run::RunOptions options = options_of(job);
    Watchers watchers(job, console, job.sample.empty() ? job.folder : fs::path());
    watchers.attach(options);
    if (job.sample.empty()) { // a sample that runs at the same time as others knows the price of its own stages only
        plan::keep_plan(job.folder, job.plan);
    }
    bound_memory(job.memory + stack_of_threads * static_cast<double>(thread_count()));
    const Stopwatch watch;
    const job::RunReport report = run_to_its_end(job, options, watchers.live());
    watchers.clear();
    for (const std::string& remark : report.remarks) {
        console.talk("warning: " + remark);
    }
    const double seconds = watch.seconds();
    const bool was_done = std::ranges::all_of(requested_plan(job).stages, &plan::StageEstimate::is_done);
    const int code = report_end(
        {job.folder, job.sample, std::ssize(record::list_samples(job.what)), seconds, was_done}, report, console
    );
    if (job.sample.empty()) {
        plan::remember_prices(job.cache, job.folder);
    }
    return code;
}

bool conduct_samples(const Job& job, const Console& console) {
    run::RunOptions options = options_of(job);
    Watchers watchers(job, console, job.live);
    watchers.attach(options);
    plan::keep_plan(job.folder, job.plan);
    bound_memory(job.memory + stack_of_threads * static_cast<double>(thread_count()));
    const bool has_ended = job::run_without_report(job.what, options);
    watchers.clear();
    if (watchers.live() && !has_ended) {
        watchers.live()->close("It was stopped early.");
    }
    plan::remember_prices(job.cache, job.folder);
    return has_ended;
}

void print_plan(const Job& job, const std::string& preposition, const Console& console) {
    const plan::RunPlan requested = requested_plan(job);
    console.talk(fmt::format(
        "case  {}   preset {}   seed {}   {}{}", job.what.title.empty() ? "without a title" : job.what.title,
        job.what.preset, job.what.seed, plural(thread_count(), "thread"),
        job.plan.speed.at_once > 1 ? fmt::format("   {} samples at once", job.plan.speed.at_once) : ""
    ));
    console.talk(fmt::format("plan  {}", plan::plan_sentence(requested)));
    if (const int most = plan::samples_at_once(job.what); job.sample.empty() && job.plan.speed.at_once < most) {
        console.talk(fmt::format(
            "      {} of {} samples at once, for the run may take {} of memory", job.plan.speed.at_once, most,
            size_text(job.memory)
        ));
    }
    for (const std::string& shortage : shortages(requested, job.folder)) {
        console.talk("warning: " + shortage);
    }
    console.talk(fmt::format("{:5} {}   report.html there shows its progress", preposition, job.folder.string()));
    const auto cached = std::count_if(requested.stages.begin(), requested.stages.end(), [](const auto& stage) {
        return stage.is_cached;
    });
    if (cached > 0) {
        console.talk(fmt::format(
            "cache {}   holds {} of the {}; --no-cache computes all", job.cache.string(), cached,
            plural(std::ssize(job.plan.stages), "stage")
        ));
    }
}

} // namespace suffuse::apps
