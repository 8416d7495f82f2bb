#include "apps/sweep_emit.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/other_program.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/refine.hpp"
#include "suffuse/record/stage_cache.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/sweep_engines.hpp"
#include "apps/sweep_scripts.hpp"
#include "apps/sweep_tasks.hpp"
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

/// A new run folder for the case, or the one that is given.
fs::path
prepare_folder(const std::string& subject, const EmitOptions& options, const Console& console, casefile::Case& what) {
    if (fs::is_directory(subject)) {
        const fs::path folder = subject;
        record::check_is_run(folder);
        what = record::load_run(folder);
        return folder;
    }
    what = load_given_case(subject, options.changes, console);
    fs::path folder = options.output;
    if (folder.empty()) {
        folder = job::make_run_folder(subject);
    } else {
        job::take_run_folder(folder);
    }
    if (!fs::exists(folder / "run_options.json")) {
        job::save_request(
            folder,
            {fs::absolute(subject).string(), options.changes.preset, options.changes.overrides, options.changes.studies,
             options.cache.is_requested() ? std::optional(options.cache.folder_or({}).string()) : std::nullopt}
        );
    }
    record::open_folder(folder, what, read_whole_file(subject));
    return folder;
}

/// Words of each call after its samples.
std::vector<std::string> words_of_calls(const EmitOptions& options) {
    std::vector<std::string> words{"-j", fmt::format("{}", std::max(1, options.threads))};
    const auto add = [&](const char* flag, const std::string& value) {
        words.emplace_back(flag);
        words.push_back(value);
    };
    if (!options.time_limit.empty()) {
        add("--time-limit", options.time_limit);
    }
    if (options.cache.is_off) {
        words.emplace_back("--no-cache");
    } else if (!options.cache.folder.empty()) {
        add("--cache", options.cache.folder_or({}).string());
    }
    return words;
}

/// Tasks that an array may have: as the engine itself says, or else its usual limit. 0: any number.
int most_tasks_of(const Engine& engine) {
    const std::optional<std::string> answer =
        engine.limit.empty() ? std::nullopt : job::output_of({"sh", "-c", std::string(engine.limit)});
    if (!answer || answer->empty() || answer->find_first_not_of("0123456789") != std::string::npos) {
        return engine.most_tasks;
    }
    const int most = static_cast<int>(std::min(1e9, std::strtod(answer->c_str(), nullptr)));
    if (most < 1) {
        throw UsageError(fmt::format(
            "--emit {}: this {} takes no arrays of jobs; --emit parallel writes the same tasks as a list of commands",
            engine.name, engine.title
        ));
    }
    return most;
}

/// What the stages that are left take with the threads of a task; nothing is computed that the cache holds.
plan::RunPlan plan_of_tasks(const casefile::Case& what, const EmitOptions& options, const fs::path& folder) {
    set_thread_count(std::max(1, options.threads));
    plan::RunPlan plan = plan::plan_case(what, 1);
    const fs::path cache = options.cache.folder_or(job::cache_next_to(folder));
    plan::leave_out_done(plan, what, folder, record::StageCache(cache, options.cache.owners()));
    return plan;
}

/// Wall time to request for each task: the time limit, a minute to save in, and the minute by which Slurm may announce
/// the end too early. Without a limit what the plan gives the longest task, twice, for nodes may be slower than this
/// machine. What takes longer is saved and goes on [s].
double requested_seconds(const std::vector<Task>& tasks, const EmitOptions& options) {
    constexpr double to_save = 120, least = 600, reserve = 2;
    if (!options.time_limit.empty()) {
        return time_limit_of(options.time_limit) + to_save;
    }
    const auto longest = std::ranges::max_element(tasks, {}, [](const Task& task) { return task.seconds.most; });
    return reserve * longest->seconds.most + least;
}

/// Tasks of as many samples as `--task-time` holds. Without it each sample is a task, unless an array holds fewer.
std::vector<Task> share_out(std::vector<Task> tasks, const EmitOptions& options, int most_tasks) {
    constexpr double usual = 600; // [s]
    if (!options.task_time.empty()) {
        return pack_tasks(tasks, time_of(options.task_time, "--task-time"));
    }
    return most_tasks > 0 && std::ssize(tasks) > most_tasks ? pack_tasks(tasks, usual) : tasks;
}

struct Emitted {
    fs::path folder; ///< as given
    std::size_t samples = 0, tasks = 0;
    int most_tasks = 0; ///< of an array
};

void report_emitted(const Emitted& emitted, const Engine& engine, const Console& console) {
    const auto [folder, samples, tasks, most] = emitted;
    const auto of_tasks = plural(static_cast<std::int64_t>(tasks), "task");
    const std::string command = command_of(engine, folder);
    console.result(
        samples == tasks
            ? fmt::format("{} in {}", of_tasks, folder.string())
            : fmt::format(
                  "{} as {} in {}", plural(static_cast<std::int64_t>(samples), "sample"), of_tasks, folder.string()
              )
    );
    console.talk("run:    " + command);
    console.talk(fmt::format("gather: suffuse sweep --collect {}", shell_word(folder.string())));
    if (most > 0 && tasks > static_cast<std::size_t>(most)) {
        console.talk(fmt::format("An array has up to {} here, so there are several.", plural(most, "task")));
    }
    if (engine.tried.empty()) {
        console.talk(fmt::format(
            "note: {} itself has never run such a script; only its syntax was checked. Look at it first.", engine.title
        ));
    }
    console.document(json_text(
        {{"folder", folder.string()},
         {"samples", samples},
         {"tasks", tasks},
         {"file", (folder / engine.file).string()},
         {"command", command}}
    ));
}

} // namespace

Option EmitOptions::add_to(Options& options, const Option& subject) {
    Option emit = options.value("--emit", engine, "write the tasks for this engine").type("ENGINE");
    emit.one_of(engine_names()).needs(subject);
    options.value("-o,--output", output, "folder of the run; runs/NAME-0001 and so on unless given").type("DIR");
    options.value("-j,--threads", threads, "threads of each task, 1 unless given").type("N").whole_number(1, 1024);
    options.value("--time-limit", time_limit, "wall time of each task, as in 2h; what is not done goes on later")
        .type("TIME");
    options
        .value("--task-time", task_time, "put as many samples into a task as take this time by the plan, as in 20min")
        .type("TIME");
    options.value("--partition", partition, "partition or queue of the cluster").type("NAME");
    options.value("--account", account, "account or project that pays for the tasks").type("NAME");
    changes.add_to(options);
    cache.add_to(options);
    return emit;
}

void EmitOptions::check() const {
    const Engine* const chosen = find_engine(engine);
    const bool takes_requests = chosen != nullptr && (chosen->most_tasks > 0 || !chosen->whole.empty());
    for (const auto& [flag, value] : {std::pair{"--partition", partition}, std::pair{"--account", account}}) {
        if (!value.empty() && !takes_requests) {
            throw UsageError(fmt::format("{} is for --emit of a cluster: slurm, pbs, sge, lsf or snakemake", flag));
        }
        if (value.find_first_of(" \t\n\"\\") != std::string::npos) {
            throw UsageError(fmt::format("{} {}: found blanks or quotes, expected a name", flag, shown(value)));
        }
    }
    time_limit_of(time_limit); // wrong use is an error before anything is made
    time_of(task_time, "--task-time");
}

int emit_tasks(const std::string& subject, const EmitOptions& options, const Console& console) {
    const Engine& engine = *find_engine(options.engine);
    const fs::path begun = fs::is_directory(subject) ? subject : options.output.empty() ? "runs/new" : options.output;
    record::StageCache(cache_to_go_on(options.cache, begun, false, console)).require_one();
    look_at_run(begun, io::Purpose::Work, console);
    const int most_tasks = most_tasks_of(engine);
    casefile::Case what;
    const fs::path folder = prepare_folder(subject, options, console, what);
    TaskRequest request;
    request.engine = &engine;
    request.folder = fs::absolute(folder).lexically_normal();
    if (request.folder.string().find('\n') != std::string::npos) {
        throw UsageError(
            fmt::format("{}: tasks are listed in lines; give -o a folder without line breaks", shown(folder))
        );
    }
    std::vector<Task> tasks = list_tasks(what, folder);
    if (tasks.empty()) {
        console.result(fmt::format("every sample is done; suffuse sweep --collect {}", shell_word(folder.string())));
        return Done;
    }
    const std::size_t samples = tasks.size();
    if (most_tasks > 0 || !engine.whole.empty() || !options.task_time.empty()) {
        constexpr double room = 1.5; // for what a plan cannot know
        const plan::RunPlan plan = plan_of_tasks(what, options, folder);
        price_tasks(tasks, plan);
        tasks = share_out(std::move(tasks), options, most_tasks);
        request.memory = room * plan.memory;
        request.seconds = requested_seconds(tasks, options);
    }
    request.program = fs::read_symlink("/proc/self/exe").string();
    request.words = words_of_calls(options);
    request.threads = std::max(1, options.threads);
    request.most_tasks = most_tasks;
    request.partition = options.partition;
    request.account = options.account;
    write_scripts(tasks, samples, request);
    report_emitted({folder, samples, tasks.size(), most_tasks}, engine, console);
    return Done;
}

} // namespace suffuse::apps
