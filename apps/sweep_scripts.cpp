#include "apps/sweep_scripts.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;
using Values = std::map<std::string, std::string>;

constexpr double megabyte = 1e6; // [B]

constexpr std::string_view head = R"(#!/bin/sh
# @what@. Submit:  @command@
# @trial@
)";

// The signals of an engine reach the script, which passes them on: the program saves its state.
constexpr std::string_view body = R"(tasks=@tasks@
number=${@index@:-@alone@}
[ "$number" -lt 1 ] || number=$((number + @before@))
task=$(sed -n "${number}p" "$tasks")
if [ -z "$task" ]; then
    echo "suffuse: $tasks has no task $number: it was written anew after this array was submitted. Cancel the array and submit $(dirname "$tasks")/submit.sh" >&2
    exit @wrong_use@
fi
eval "exec $task" &
program=$!
for signal in HUP INT TERM USR1 USR2 XCPU; do
    trap "kill -$signal $program 2>/dev/null" "$signal"
done
while :; do
    code=0
    wait "$program" || code=$?
    kill -0 "$program" 2>/dev/null || break
done
case $code in
@go_on@
esac
exit "$code"
)";

constexpr std::string_view submission = R"(#!/bin/sh
# Submits the tasks of a run of suffuse to @title@, and a job that gathers what they left when they have ended.
set -eu
jobs=
for script in @scripts@; do
    job=$(@submit@)
    [ -n "$job" ] || { echo "suffuse: $script was not submitted; submitted before it: ${jobs:-nothing}" >&2 && exit 1; }
    echo "$script: job $job"
    jobs="$jobs${jobs:+@joint@}@job@"
done
script=@gather_script@
@gather@
)";

/// A word in double quotes, with a backslash before what is meant as it stands: as Slurm's directives and Python have
/// it.
std::string quoted(const std::string& word) {
    std::string text = "\"";
    for (const char c : word) {
        if (c == '"' || c == '\\') {
            text += '\\';
        }
        text += c;
    }
    return text + "\"";
}

/// A name that any engine takes for a job.
std::string plain_name(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_' && c != '.'; }, '_'
    );
    return name;
}

/// The log below tasks/; in Slurm's names % begins a pattern, and %% stands for one.
std::string log_name(const TaskRequest& request, const std::string& name) {
    std::string folder = (request.folder / record::tasks_folder).string();
    if (request.engine->log.starts_with('%')) {
        for (std::size_t at = folder.find('%'); at != std::string::npos; at = folder.find('%', at + 2)) {
            folder.insert(at, 1, '%');
        }
    }
    return quoted(folder + "/" + name);
}

std::string clock_text(double seconds) {
    const auto whole = std::llround(std::ceil(seconds));
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string whole_number(double value) {
    return fmt::format("{:.0f}", std::ceil(value));
}

/// One task, as a shell runs it.
std::string task_text(const Task& task, const TaskRequest& request) {
    std::string text = fmt::format("{} resume {}", shell_word(request.program), shell_word(request.folder.string()));
    for (const std::string& sample : task.samples) {
        text += " --sample " + shell_word(sample);
    }
    for (const std::string& word : request.words) {
        text += " " + shell_word(word);
    }
    return text + "\n";
}

std::string path_of(const TaskRequest& request, const std::string& name) {
    return (request.folder / name).string();
}

/// What all scripts of a request have in common.
Values common_values(const TaskRequest& request, const std::string& what) {
    const Engine& engine = *request.engine;
    const std::string job = "suffuse-" + request.folder.filename().string();
    const std::string again =
        fmt::format("suffuse sweep {} --emit {}", shell_word(request.folder.string()), engine.name);
    return {
        {"what", what},
        {"title", std::string(engine.title)},
        {"trial", engine.tried.empty()
                      ? fmt::format("Never run by {} itself: only the syntax of this script was checked.", engine.title)
                      : fmt::format("Tried with {} {}.", engine.title, engine.tried)},
        {"command", command_of(engine, request.folder)},
        {"again", again},
        {"job", quoted(job)},
        {"plain_job", plain_name(job)},
        {"threads", fmt::format("{}", request.threads)},
        {"several_threads", request.threads > 1 ? fmt::format("{}", request.threads) : ""},
        {"memory", whole_number(request.memory / megabyte)},
        {"memory_of_thread", whole_number(request.memory / megabyte / request.threads)},
        {"minutes", whole_number(request.seconds / 60)},
        {"clock", clock_text(request.seconds)},
        {"partition", request.partition},
        {"account", request.account},
        {"array", ""},
        {"range", ""},
        {"single_job", ""},
        {"wrong_use", fmt::format("{}", static_cast<int>(WrongUse))},
        {"index", std::string(engine.index)},
        {"tasks", shell_word(path_of(request, "tasks.txt"))}};
}

/// The script of an array.
std::string array_text(const TaskRequest& request, const std::string& what, std::size_t before, std::size_t count) {
    const Engine& engine = *request.engine;
    Values values = common_values(request, what);
    const std::size_t number = request.most_tasks > 0 ? before / static_cast<std::size_t>(request.most_tasks) + 1 : 1;
    values["array"] = fmt::format("1-{}", count);
    values["range"] = count > 1 ? values["array"] : ""; // PBS has no array of one
    values["alone"] = count > 1 ? "0" : "1";
    values["before"] = fmt::format("{}", before);
    values["log"] = log_name(request, (number > 1 ? fmt::format("{}-", number) : "") + std::string(engine.log));
    values["go_on"] = fill_template(engine.go_on, values);
    values["go_on"].pop_back(); // its line ends in the text around it
    return fill_template(head, values) + fill_template(engine.directives, values) + fill_template(body, values);
}

/// The script that gathers what tasks have left.
std::string gather_text(const TaskRequest& request) {
    constexpr double least_memory = 2000 * megabyte, seconds = 7200;
    TaskRequest own = request;
    own.threads = 1;
    own.memory = std::max(request.memory, least_memory);
    own.seconds = seconds;
    Values values = common_values(own, "Gathers what the tasks of a run of suffuse have left, into one report");
    values["single_job"] = values["plain_job"];
    values["log"] = log_name(request, "gather.txt");
    return fill_template(head, values) + fill_template(request.engine->directives, values) +
           fmt::format(
               "exec {} sweep --collect {}\n", shell_word(request.program), shell_word(request.folder.string())
           );
}

std::string script_name(const Engine& engine, const std::string& stem) {
    return stem + fs::path(engine.file).extension().string();
}

/// Arrays of as many tasks as the engine takes in one, a script each, and a script that submits them.
void write_arrays(std::size_t tasks, const std::string& what, const TaskRequest& request) {
    const Engine& engine = *request.engine;
    const std::size_t most = request.most_tasks > 0 ? static_cast<std::size_t>(request.most_tasks) : tasks;
    std::string scripts;
    for (std::size_t before = 0, number = 1; before < tasks; before += most, ++number) {
        const std::string name = script_name(engine, number == 1 ? "sweep" : fmt::format("sweep-{}", number));
        io::write_file(request.folder / name, array_text(request, what, before, std::min(most, tasks - before)));
        scripts += (scripts.empty() ? "" : " ") + shell_word(path_of(request, name));
    }
    const std::string gather = script_name(engine, "gather");
    io::write_file(request.folder / gather, gather_text(request));
    io::write_file(
        request.folder / "submit.sh", fill_template(
                                          submission, {{"title", std::string(engine.title)},
                                                       {"scripts", scripts},
                                                       {"submit", std::string(engine.submit)},
                                                       {"joint", std::string(engine.joint)},
                                                       {"job", std::string(engine.job)},
                                                       {"gather_script", shell_word(path_of(request, gather))},
                                                       {"gather", std::string(engine.gather)}}
                                      )
    );
}

/// Scripts of an earlier call would run tasks that are others now; flags of Snakemake would pass over them.
void remove_earlier(const fs::path& folder) {
    std::vector<fs::path> earlier;
    const auto take = [&](const fs::path& where, const auto& is_meant) {
        for (const auto& entry : fs::directory_iterator(where)) {
            if (!entry.is_directory() && is_meant(entry.path())) {
                earlier.push_back(entry.path());
            }
        }
    };
    take(folder, [](const fs::path& file) {
        const std::string stem = file.stem().string();
        const bool is_script = stem == "sweep" || stem.starts_with("sweep-") || stem == "gather";
        return file.filename() == "submit.sh" ||
               (is_script && std::ranges::any_of(engines(), [&](const Engine& engine) {
                    return file.extension() == fs::path(engine.file).extension();
                }));
    });
    take(folder / record::tasks_folder, [](const fs::path& file) { return file.extension() == ".done"; });
    for (const fs::path& file : earlier) {
        io::remove_file(file);
    }
}

} // namespace

std::string command_of(const Engine& engine, const fs::path& folder) {
    const std::string file(engine.most_tasks > 0 ? "submit.sh" : engine.file);
    const std::string pattern(engine.most_tasks > 0 ? "sh @script@" : engine.command);
    return fill_template(pattern, {{"script", shell_word((folder / file).string())}});
}

void write_scripts(const std::vector<Task>& tasks, std::size_t samples, const TaskRequest& request) {
    const Engine& engine = *request.engine;
    io::make_folders(request.folder / record::tasks_folder);
    remove_earlier(request.folder);
    std::string lines;
    for (const Task& task : tasks) {
        lines += task_text(task, request);
    }
    io::write_file(request.folder / "tasks.txt", lines);
    const std::string what = fmt::format(
        "{} of a run of suffuse, {}", plural(static_cast<std::int64_t>(samples), "sample"),
        samples == tasks.size() ? "one a task" : "in " + plural(std::ssize(tasks), "task")
    );
    if (engine.most_tasks > 0) {
        write_arrays(tasks.size(), what, request);
    }
    if (engine.whole.empty()) {
        return;
    }
    Values values = common_values(request, what);
    values["folder"] = quoted(request.folder.string());
    values["tasks"] = quoted(path_of(request, "tasks.txt"));
    values["collect"] =
        quoted(fmt::format("{} sweep --collect {}", shell_word(request.program), shell_word(request.folder.string())));
    io::write_file(request.folder / engine.file, fill_template(engine.whole, values));
}

} // namespace suffuse::apps
