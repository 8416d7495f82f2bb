// resume: a run that was stopped goes on.

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/stopwatch.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/run_tree.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/requested_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

#include "apps/complaint.hpp"
#include "apps/conduct_calibration.hpp"
#include "apps/conduct_job.hpp"
#include "apps/exit_code.hpp"
#include "apps/shared_options.hpp"
#include "apps/stop_signal.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct ResumeVerb final : Verb {
    ResumeVerb()
        : Verb(
              "resume", "continue a stopped run, with bit-identical results",
              "suffuse resume runs/dyke-0001 --time-limit 2h"
          ) {}

    std::string folder;
    ThreadOption threads;
    CacheOptions cache;
    RunLimits limits;
    MemoryOption memory;
    std::vector<std::string> samples;
    bool is_trusted = false;

    void add_to(Options& options) override {
        options.argument("DIR", folder, folder_text).required();
        threads.add_to(options);
        cache.add_to(options);
        options.flag(
            "--trust", is_trusted, "use the cache named in run_options.json of the run; only for runs of your own"
        );
        limits.add_to(options);
        memory.add_to(options);
        options
            .values(
                "--sample", samples,
                "only this sample, while others run elsewhere; as in fines/fc=20/rep=1; repeated: one after the other"
            )
            .type("NAME");
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;
};

/// @throws UsageError where there is no such sample.
void check_samples(const casefile::Case& what, const std::vector<std::string>& requested) {
    std::vector<std::string> names;
    for (const record::Sample& sample : record::list_samples(what)) {
        names.push_back(sample.variant->folder);
    }
    for (const std::string& name : requested) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            throw UsageError(fmt::format(
                "--sample {}: the run has no such sample{}; suffuse plan lists them", shown(name),
                near_hint(name, names)
            ));
        }
    }
}

/// The job's sample, or all of them, to their end. @return the exit code
int resume_part(Job& job, const Console& console) {
    std::optional<job::FolderLock> own_lock;
    if (!job.sample.empty()) {
        const fs::path own = job.folder / "studies" / job.sample;
        io::make_folders(own);
        own_lock.emplace(own, console.warner());
    }
    if (const std::optional<int> code = look_before(job, console)) {
        return *code;
    }
    job.plan = plan_rest(job);
    print_plan(job, "in", console);
    return conduct(job, console);
}

/// Samples of one task, one after the other. One that fails keeps none of the others waiting, nor does one that another
/// program works on. @return the code of the first that failed; what ends the call where a signal or the time did
int resume_samples(Job& job, const std::vector<std::string>& samples, const Console& console) {
    const double time_limit = job.time_limit;
    const Stopwatch watch;
    int failed = Done, flawed = Done;
    for (const std::string& sample : samples) {
        job.sample = sample;
        job.time_limit = time_limit - watch.seconds();
        if (stop_flag()) {
            return signal_exit_code();
        }
        if (!(job.time_limit > 0)) {
            console.talk(fmt::format("time limit reached before {}", sample));
            return OutOfTime;
        }
        int code = Done;
        try {
            code = resume_part(job, console);
        } catch (...) {
            code = complain_about_current(console);
        }
        if (code == OutOfTime || code >= BySignal) {
            return code;
        }
        if (code == Flawed) {
            flawed = code;
        } else if (failed == Done) {
            failed = code;
        }
    }
    return failed != Done ? failed : flawed;
}

int resume_calibration(const ResumeVerb& verb, const std::string& command, const Console& console) {
    const job::RunRequest request = job::read_request(verb.folder);
    verb.threads.apply();
    const job::FolderLock lock(verb.folder, console.warner());
    return conduct_calibration(
        {.case_file = request.case_file,
         .overrides = request.overrides,
         .folder = verb.folder,
         .cache = cache_to_go_on(verb.cache, verb.folder, verb.is_trusted, console),
         .cache_owners = verb.cache.owners(),
         .time_limit = verb.limits.seconds(),
         .memory = verb.memory.bytes(),
         .command = command},
        console
    );
}

int ResumeVerb::act(const CommandLine& line, const Console& console) const {
    if (samples.size() > 1 && console.wants_json()) {
        throw UsageError("--json prints one document: give one --sample with it");
    }
    Job job{
        .until = limits.until,
        .time_limit = limits.seconds(), // wrong use is an error before anything is made
        .memory = memory.bytes(),
        .command = line.typed,
        .folder = folder};
    handle_signals();
    io::look_into_run(
        job.folder, io::Purpose::Work
    ); // before any of it is read; what it remarks on comes with the lock
    const fs::path resolved = job.folder / record::resolved_case_file;
    if (job::is_calibration(job.folder)) {
        return resume_calibration(*this, line.typed, console);
    }
    job.cache = cache_to_go_on(cache, job.folder, is_trusted, console);
    job.cache_owners = cache.owners();
    record::StageCache(job.cache).require_one();
    if (fs::exists(resolved)) {
        job.what = record::load_run(job.folder);
    } else { // stopped before it really began
        const job::RunRequest request = job::read_request(job.folder);
        job.what = casefile::load_case(request.case_file, {request.preset, request.overrides, request.studies}).value;
        job.case_text = read_whole_file(request.case_file);
    }
    plan::check_until(job.what, limits.until);
    check_samples(job.what, samples);
    threads.apply();
    const auto kind = samples.empty() ? job::FolderLock::Kind::Alone : job::FolderLock::Kind::Shared;
    const job::FolderLock lock(job.folder, console.warner(), kind);
    if (samples.size() > 1) {
        return resume_samples(job, samples, console);
    }
    job.sample = samples.empty() ? "" : samples.front();
    return resume_part(job, console);
}

} // namespace

MadeVerb make_resume_verb() {
    return std::make_unique<ResumeVerb>();
}

} // namespace suffuse::apps
