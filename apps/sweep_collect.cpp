#include "apps/sweep_collect.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/failures.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/run_ending.hpp"
#include "apps/sweep_engines.hpp"
#include <algorithm>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

/// Samples that have neither ended nor failed.
std::vector<std::string>
find_unfinished(const std::vector<record::Sample>& samples, const fs::path& folder, const job::RunReport& report) {
    std::vector<std::string> unfinished;
    for (const record::Sample& sample : samples) {
        const std::string& name = sample.variant->folder;
        const bool has_failed = std::any_of(report.failures.begin(), report.failures.end(), [&](const auto& failure) {
            return failure.sample == name;
        });
        if (!has_failed && !record::is_complete(sample, folder)) {
            unfinished.push_back(name);
        }
    }
    return unfinished;
}

void print_unfinished(const std::vector<std::string>& unfinished, const fs::path& folder, const Console& console) {
    for (const std::string& name : unfinished) {
        console.detail("not finished: " + name);
    }
    if (!unfinished.empty()) {
        const auto before = std::ranges::find_if(engines(), [&](const Engine& engine) {
            return fs::exists(folder / engine.file); // all have tasks.txt, which is last
        });
        const std::string_view form = before == engines().end() ? engines().back().name : before->name;
        console.talk(fmt::format(
            "{} not finished: suffuse sweep {} --emit {} writes tasks for them, suffuse resume {} runs them here",
            plural(std::ssize(unfinished), "sample"), shell_word(folder.string()), form, shell_word(folder.string())
        ));
    }
}

} // namespace

int collect_tasks(const fs::path& folder, const std::string& command, const Console& console) {
    record::check_is_run(folder); // before the lock, which would leave a file there
    const job::FolderLock lock(folder, console.warner());
    const std::string doubts = record::require_whole_run(folder);
    if (!doubts.empty()) {
        console.talk("warning: " + doubts);
    }
    const std::vector<record::Refinement> refined = record::find_refinements(record::load_run(folder), folder);
    if (!refined.empty()) {
        record::keep_refinements(folder, refined);
    }
    const casefile::Case what = record::load_run(folder);
    const std::vector<record::Sample> samples = record::list_samples(what);
    if (std::any_of(samples.begin(), samples.end(), [&](const record::Sample& sample) {
            return fs::exists(folder / "studies" / sample.variant->folder / "provenance.json"); // was a task's
        })) {
        fs::remove(folder / "provenance.json"); // of an earlier gathering, which had fewer of them
    }
    const job::RunReport report = job::rebuild_report(folder, page_folder(), command);
    const std::vector<std::string> unfinished = find_unfinished(samples, folder, report);
    const auto done = samples.size() - unfinished.size() - report.failures.size();
    print_results(
        report,
        fmt::format(
            "{} of {} done{}", done, plural(std::ssize(samples), "sample"), report.flaws.empty() ? "" : " with flaws"
        ),
        console
    );
    if (!report.failures.empty()) {
        print_failures(report.failures, std::ssize(samples), folder, console);
    }
    print_unfinished(unfinished, folder, console);
    const int code = !report.failures.empty() ? code_of(report.failures)
                     : !unfinished.empty()    ? OutOfTime
                     : report.flaws.empty()   ? Done
                                              : Flawed;
    console.document(json_text(
        {{"folder", folder.string()},
         {"exit_code", code},
         {"report", report.report.string()},
         {"samples", samples.size()},
         {"done", done},
         {"unfinished", unfinished},
         {"failures", report.failures},
         {"warnings", report.warnings},
         {"flaws", report.flaws},
         {"findings", report.findings}}
    ));
    return code;
}

} // namespace suffuse::apps
