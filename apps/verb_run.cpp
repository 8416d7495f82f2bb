// run: a case from its first stage to its report.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/plan/requested_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/conduct_job.hpp"
#include "apps/exit_code.hpp"
#include "apps/shared_options.hpp"
#include "apps/stop_signal.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct RunVerb final : Verb {
    RunVerb()
        : Verb(
              "run", "run a case and write its report",
              "suffuse run dyke/case.toml --preset quick --set study.erosion.particles=4000 -o runs/small"
          ) {}

    std::string given; ///< a case, or the folder that holds one
    ThreadOption threads;
    std::string output;
    CaseChanges changes;
    CacheOptions cache;
    RunLimits limits;
    MemoryOption memory;

    void add_to(Options& options) override {
        options.argument("CASE", given, case_text).required();
        threads.add_to(options);
        options.value("-o,--output", output, "folder of the run; runs/NAME-0001 and so on unless given").type("DIR");
        changes.add_to(options);
        cache.add_to(options);
        limits.add_to(options);
        memory.add_to(options);
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;
};

/// "--preset standard (20-40 min)" after a quick run. The case is read anew for it, and what it holds by then, or
/// says of that preset, must not turn a run that succeeded into a failure: nothing where it has errors.
std::string larger_hint(const RunVerb& verb, const Job& job) {
    if (job.what.preset != "quick") {
        return "";
    }
    try {
        const casefile::Case larger =
            casefile::load_case(case_in(verb.given), {"standard", verb.changes.overrides, verb.changes.studies}).value;
        return fmt::format(
            "--preset standard ({})", duration_range_text(plan::plan_run(larger, job.plan.speed).seconds)
        );
    } catch (const Error&) {
        return "";
    }
}

int RunVerb::act(const CommandLine& line, const Console& console) const {
    Job job{
        .until = limits.until,
        .time_limit = limits.seconds(), // wrong use is an error before anything is made
        .memory = memory.bytes(),
        .command = line.typed};
    handle_signals();
    const std::string file = case_in(given);
    job.what = load_given_case(file, changes, console);
    plan::check_until(job.what, limits.until);
    job.case_text = read_whole_file(file);
    threads.apply();
    job.cache = cache.folder_or(job::cache_next_to(output.empty() ? "runs/new" : output));
    job.cache_owners = cache.owners();
    record::StageCache(job.cache).require_one();
    job.folder = output;
    job.plan = plan_rest(job); // where it throws no folder is left
    if (output.empty()) {
        job.folder = job::make_run_folder(file);
    } else {
        job::take_run_folder(job.folder);
    }
    const job::FolderLock lock(job.folder, console.warner());
    if (!fs::exists(job.folder / "run_options.json")) {
        job::save_request(
            job.folder, {fs::absolute(file).string(), changes.preset, changes.overrides, changes.studies,
                         cache.is_requested() ? std::optional(job.cache.string()) : std::nullopt}
        );
    }
    record::open_folder(job.folder, job.what, job.case_text); // another case's is refused before the plan is shown
    if (const std::optional<int> code = look_before(job, console)) {
        return *code;
    }
    print_plan(job, "into", console);
    const int code = conduct(job, console);
    if (code == Done) {
        std::vector<std::string> hints;
        if (std::string larger = larger_hint(*this, job); !larger.empty()) {
            hints.push_back(std::move(larger));
        }
        if (!job.what.paper.empty()) { // an example
            hints.emplace_back("your own soil, suffuse new --psd FILE");
        }
        if (!hints.empty()) {
            console.talk(fmt::format("next: {}", fmt::join(hints, "; ")));
        }
    }
    return code;
}

} // namespace

MadeVerb make_run_verb() {
    return std::make_unique<RunVerb>();
}

} // namespace suffuse::apps
