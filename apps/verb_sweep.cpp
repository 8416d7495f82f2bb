// sweep: the samples of a case as tasks that any machine can run, and one run folder gathered from what they leave.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/run_case.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/record/finished_stages.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/missing_stages.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/samples.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/failures.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/run_ending.hpp"
#include "apps/shared_options.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct SweepVerb final : Verb {
    SweepVerb()
        : Verb(
              "sweep", "run the samples of a case as tasks of a cluster, and gather them",
              "suffuse sweep dyke/case.toml --emit slurm -o runs/dyke && sbatch runs/dyke/sweep.sbatch\n"
              "suffuse sweep --collect runs/dyke"
          ) {}

    std::string subject;   ///< a case, or the folder of a run
    std::string form;      ///< slurm or parallel
    std::string collected; ///< folder of the run whose tasks are done
    std::string output;
    int threads = 0;        ///< of each task
    std::string time_limit; ///< of each task, with its unit
    CaseChanges changes;
    CacheOptions cache;

    void add_to(Options& options) override {
        const Option from =
            options.argument("CASE", subject, "the case file, or the folder of a run whose rest is to be run");
        const Option emit = options.value("--emit", form, "write the tasks: slurm, or parallel (GNU parallel, sh)")
                                .type("FORM")
                                .one_of({"slurm", "parallel"})
                                .needs(from);
        options.value("--collect", collected, "gather what the tasks left in the folder DIR")
            .type("DIR")
            .excludes(emit)
            .excludes(from);
        options.value("-o,--output", output, "folder of the run; runs/NAME-0001 and so on unless given").type("DIR");
        options.value("-j,--threads", threads, "threads of each task, 1 unless given").type("N").whole_number(1, 1024);
        options.value("--time-limit", time_limit, "wall time of each task, as in 2h; what is not done goes on later")
            .type("TIME");
        changes.add_to(options);
        cache.add_to(options);
    }

    void check() const override {
        if (form.empty() && collected.empty()) {
            throw UsageError(
                "sweep: --emit slurm or --emit parallel with a case, or --collect DIR; suffuse run CASE runs all "
                "samples on this machine"
            );
        }
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;
};

/// A word behind #SBATCH: Slurm knows double quotes, and a backslash before what is meant as it stands.
std::string for_slurm(const std::string& word) {
    std::string text = "\"";
    for (const char c : word) {
        if (c == '"' || c == '\\') {
            text += '\\';
        }
        text += c;
    }
    return text + "\"";
}

/// In a name of Slurm's output % begins what Slurm fills in.
std::string without_patterns(const std::string& path) {
    std::string text;
    for (const char c : path) {
        text += c == '%' ? "%%" : std::string(1, c);
    }
    return text;
}

struct Emitted {
    casefile::Case what;
    fs::path folder; ///< absolute: tasks run from anywhere
    std::vector<record::Sample> left;
};

/// A new run folder for the case, or the one that is given.
fs::path prepare_folder(const SweepVerb& verb, const Console& console, casefile::Case& what) {
    if (fs::is_directory(verb.subject)) {
        const fs::path folder = verb.subject;
        if (!fs::exists(folder / record::resolved_case_file)) {
            throw UsageError(fmt::format(
                "{} holds no run; give a case file, or the folder that suffuse run printed", shown(verb.subject)
            ));
        }
        what = record::load_run(folder);
        return folder;
    }
    what = load_given_case(verb.subject, verb.changes, console);
    fs::path folder = verb.output;
    if (folder.empty()) {
        folder = job::make_run_folder(verb.subject);
    } else {
        job::take_run_folder(folder);
    }
    if (!fs::exists(folder / "run_options.json")) {
        job::save_request(
            folder,
            {fs::absolute(verb.subject).string(), verb.changes.preset, verb.changes.overrides, verb.changes.studies,
             verb.cache.is_requested() ? std::optional(verb.cache.folder_or({}).string()) : std::nullopt}
        );
    }
    record::open_folder(folder, what, read_whole_file(verb.subject));
    return folder;
}

/// One task, as a shell runs it.
std::string task_text(const Emitted& emitted, const record::Sample& sample, const SweepVerb& verb) {
    const std::string limit = verb.time_limit.empty() ? "" : " --time-limit " + shell_word(verb.time_limit);
    const std::string cache = verb.cache.is_off           ? " --no-cache"
                              : verb.cache.folder.empty() ? ""
                                                          : " --cache " + shell_word(verb.cache.folder_or({}).string());
    return fmt::format(
        "{} resume {} --sample {} -j {}{}{}\n", shell_word(fs::read_symlink("/proc/self/exe").string()),
        shell_word(emitted.folder.string()), shell_word(sample.variant->folder), std::max(1, verb.threads), limit, cache
    );
}

/// Memory for a task, with room for what a plan cannot know [MB].
int memory_of_task(const casefile::Case& what) {
    constexpr double room = 1.5, megabyte = 1e6;
    const plan::RunPlan plan = plan::plan_case(what, 1);
    return static_cast<int>(std::ceil(room * plan.memory / megabyte));
}

std::string slurm_text(const Emitted& emitted, const SweepVerb& verb) {
    constexpr double warning = 60; // seconds before the end at which Slurm asks the task to save
    std::string time;
    if (!verb.time_limit.empty()) {
        const double limit = time_limit_of(verb.time_limit);
        time = fmt::format("#SBATCH --time={}\n", static_cast<int>(std::ceil((limit + warning) / 60)));
    }
    const std::string folder = emitted.folder.string();
    return fmt::format(
        "#!/bin/sh\n"
        "# {} of a run of suffuse, one a task. Submit:  sbatch {}\n"
        "# A stopped task saves its state and continues when submitted again. Then:  suffuse sweep --collect {}\n"
        "#SBATCH --job-name={}\n"
        "#SBATCH --array=1-{}\n"
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task={}\n"
        "#SBATCH --mem={}M\n"
        "#SBATCH --output={}\n"
        "#SBATCH --signal=B:TERM@{:.0f}\n"
        "{}tasks={}\n"
        "task=$(sed -n \"${{SLURM_ARRAY_TASK_ID:-0}}p\" \"$tasks\")\n"
        "if [ -z \"$task\" ]; then\n"
        "    echo \"suffuse: $tasks has no task ${{SLURM_ARRAY_TASK_ID:-0}}: it was written anew after this array was "
        "submitted. Cancel the array and submit $(dirname \"$tasks\")/sweep.sbatch\" >&2\n"
        "    exit {}\n"
        "fi\n"
        "eval \"exec $task\"\n",
        plural(std::ssize(emitted.left), "sample"), shell_word(folder + "/sweep.sbatch"), shell_word(folder),
        for_slurm("suffuse-" + emitted.folder.filename().string()), emitted.left.size(), std::max(1, verb.threads),
        memory_of_task(emitted.what), for_slurm(without_patterns(folder) + "/tasks/%a.txt"), warning, time,
        shell_word(folder + "/tasks.txt"), static_cast<int>(WrongUse)
    );
}

int emit(const SweepVerb& verb, const Console& console) {
    time_limit_of(verb.time_limit); // wrong use is an error before anything is made
    const fs::path begun = fs::is_directory(verb.subject) ? verb.subject
                           : verb.output.empty()          ? "runs/new"
                                                          : verb.output;
    record::StageCache(cache_to_go_on(verb.cache, begun, false, console)).require_one();
    look_at_run(begun, io::Purpose::Work, console);
    Emitted emitted;
    const fs::path folder = prepare_folder(verb, console, emitted.what);
    emitted.folder = fs::absolute(folder).lexically_normal();
    if (emitted.folder.string().find('\n') != std::string::npos) {
        throw UsageError(
            fmt::format("{}: tasks are listed in lines; give -o a folder without line breaks", shown(folder))
        );
    }
    std::string tasks;
    for (const record::Sample& sample : record::list_samples(emitted.what)) {
        if (!record::is_complete(sample, folder)) {
            emitted.left.push_back(sample);
            tasks += task_text(emitted, sample, verb);
        }
    }
    if (emitted.left.empty()) {
        console.result(fmt::format("every sample is done; suffuse sweep --collect {}", shell_word(folder.string())));
        return Done;
    }
    io::write_file(folder / "tasks.txt", tasks);
    io::make_folders(folder / "tasks");
    std::string how =
        fmt::format("parallel < {0}     (or one after the other: sh {0})", shell_word((folder / "tasks.txt").string()));
    if (verb.form == "slurm") {
        set_thread_count(std::max(1, verb.threads));
        io::write_file(folder / "sweep.sbatch", slurm_text(emitted, verb));
        how = fmt::format("sbatch {}", shell_word((folder / "sweep.sbatch").string()));
    }
    console.result(fmt::format("{} in {}", plural(std::ssize(emitted.left), "task"), folder.string()));
    console.talk("run:    " + how);
    console.talk(fmt::format("gather: suffuse sweep --collect {}", shell_word(folder.string())));
    console.document(json_text(
        {{"folder", folder.string()},
         {"tasks", emitted.left.size()},
         {"file", (folder / (verb.form == "slurm" ? "sweep.sbatch" : "tasks.txt")).string()}}
    ));
    return Done;
}

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
        const char* const form = fs::exists(folder / "sweep.sbatch") ? "slurm" : "parallel"; // as before
        console.talk(fmt::format(
            "{} not finished: suffuse sweep {} --emit {} writes tasks for them, suffuse resume {} runs them here",
            plural(std::ssize(unfinished), "sample"), shell_word(folder.string()), form, shell_word(folder.string())
        ));
    }
}

int collect(const SweepVerb& verb, const std::string& command, const Console& console) {
    const fs::path folder = verb.collected;
    if (!fs::exists(folder / record::resolved_case_file)) {
        throw UsageError(
            fmt::format("{} holds no run; give the folder that suffuse sweep --emit has named", shown(verb.collected))
        );
    }
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

int SweepVerb::act(const CommandLine& line, const Console& console) const {
    return collected.empty() ? emit(*this, console) : collect(*this, line.typed, console);
}

} // namespace

MadeVerb make_sweep_verb() {
    return std::make_unique<SweepVerb>();
}

} // namespace suffuse::apps
