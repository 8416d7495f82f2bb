// A case: made from a curve or an example, checked, priced, and started as a run.

#include "suffuse/base/read_text.hpp"
#include "suffuse/casefile/calibration_case.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/run_folder.hpp"

#include <fmt/format.h>

#include "apps/studio/routes.hpp"
#include "apps/studio/run_folders.hpp"
#include <chrono>
#include <sys/wait.h>
#include <thread>

namespace suffuse::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A new case as the page holds it: its text, and the data that it names.
json case_in(const fs::path& folder) {
    json files = json::object();
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (entry.is_regular_file() && name != "case.toml") {
            files[name] = read_whole_file(entry.path().string());
        }
    }
    return {{"case", read_whole_file((folder / "case.toml").string())}, {"files", files}};
}

void make_case(const httplib::Request& request, httplib::Response& response) {
    const ScratchFolder folder;
    std::vector<std::string> words{"new", "case"};
    if (request.has_file("curve")) {
        words.push_back("--psd=" + take_upload(request, "curve", folder.path()));
        add_options(
            request,
            {"sample", "size", "passing", "retained", "share", "mass", "by", "sheet", "rows", "fines", "sizes",
             "particles", "pressure", "gradient", "flow", "filter-sample"},
            words
        );
        if (request.has_file("filter")) {
            words.push_back("--filter=" + take_upload(request, "filter", folder.path()));
        }
        if (field(request, "surrogate") == "yes") {
            words.emplace_back("--surrogate");
        }
    } else {
        add_options(request, {"from"}, words);
    }
    ProgramCall call = call_program(words, folder.path());
    if (call.code == 0) {
        call.document.update(case_in(folder.path() / "case"));
    }
    answer_call(response, call);
}

ProgramCall plan_in(const fs::path& folder, const std::vector<std::string>& preset, const fs::path& cache) {
    std::vector<std::string> words{"plan", "case.toml", "--cache=" + cache.string()};
    words.insert(words.end(), preset.begin(), preset.end());
    return call_program(words, folder);
}

void check(const httplib::Request& request, httplib::Response& response) {
    const ScratchFolder folder;
    take_case(request, folder.path());
    std::vector<std::string> words{"check", "case.toml"};
    add_options(request, {"preset"}, words);
    answer_call(response, call_program(words, folder.path()));
}

/// How the record of a laboratory's tests is understood.
void read_record(const httplib::Request& request, httplib::Response& response) {
    const ScratchFolder folder;
    std::vector<std::string> words{"import", take_upload(request, "record", folder.path())};
    add_options(request, {"kind", "contraction"}, words);
    answer_call(response, call_program(words, folder.path()));
}

void plan(const httplib::Request& request, httplib::Response& response, const Studio& studio) {
    const ScratchFolder folder;
    take_case(request, folder.path());
    std::vector<std::string> preset;
    add_options(request, {"preset"}, preset);
    answer_call(response, plan_in(folder.path(), preset, job::cache_next_to(studio.folder / "new")));
}

/// Memory of the runs that are at work, by their plans [B].
double memory_in_use(const fs::path& folder) {
    double bytes = 0;
    for (const fs::path& run : runs_at_work(folder)) {
        if (const fs::path file = work_folder(run) / "plan.json"; fs::is_regular_file(fs::symlink_status(file))) {
            const json kept = json::parse(read_whole_file(file.string()), nullptr, false);
            bytes += kept.is_object() ? kept.value("memory", 0.0) : 0.0;
        }
    }
    return bytes;
}

/// @throws Refusal 409 where it would not fit next to what runs.
void require_memory(const fs::path& folder, const json& plan) {
    const json& samples = plan.contains("first_round") ? plan.at("first_round") : plan; // of a calibration: all alike
    const double used = memory_in_use(folder), needed = samples.value("memory", 0.0),
                 most = samples.value("memory_limit", 0.0);
    if (used > 0 && used + needed > most) {
        throw Refusal(
            409, fmt::format(
                     "this run needs {:.1f} GB of memory, the runs at work need {:.1f} GB, and {:.1f} GB may be used; "
                     "start it when one of them has ended",
                     needed / 1e9, used / 1e9, most / 1e9
                 )
        );
    }
}

/// Starts the program and waits until it has published its plan, or ended. @throws Refusal 422 with its last words
void start_and_watch(
    const Studio& studio, const std::vector<std::string>& words, const fs::path& run, const fs::path& log
) {
    const pid_t child = start_program(words, studio.folder, log);
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    int status = 0;
    bool has_ended = false;
    while (!has_ended && !(job::is_at_work(run) && fs::exists(work_folder(run) / "progress.json")) &&
           std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        has_ended = waitpid(child, &status, WNOHANG) == child;
    }
    if (!has_ended) {
        std::thread([child] { waitpid(child, nullptr, 0); }).detach(); // so that it leaves the list of processes
    } else if (!fs::exists(work_folder(run) / "events.jsonl")) {
        throw Refusal(422, last_words(log));
    }
}

void start(const httplib::Request& request, httplib::Response& response, Studio& studio) {
    const std::string name = folder_name(field(request, "name"));
    std::vector<std::string> preset;
    add_options(request, {"preset"}, preset);
    const std::scoped_lock lock(studio.starting);
    {
        const ScratchFolder scratch;
        take_case(request, scratch.path());
        const ProgramCall price = plan_in(scratch.path(), preset, job::cache_next_to(studio.folder / "new"));
        if (price.code != 0) {
            answer_call(response, price);
            return;
        }
        require_memory(studio.folder, price.document);
    }
    const fs::path run = make_numbered_folder(studio.folder, name);
    const fs::path folder = studio.folder / "cases" / run.filename(); // next to the runs, and kept with them
    io::make_folders(folder);
    take_case(request, folder);
    const bool is_calibration = casefile::calibrates((folder / "case.toml").string()); // which knows no preset
    std::vector<std::string> words{
        is_calibration ? "calibrate" : "run", (fs::path("cases") / run.filename() / "case.toml").string(),
        "--output=" + run.filename().string()};
    add_options(request, {is_calibration ? "time-limit" : "preset"}, words);
    start_and_watch(studio, words, run, folder / "log.txt");
    answer(response, 201, {{"run", run.filename().string()}});
}

void resume(const httplib::Request& request, httplib::Response& response, Studio& studio) {
    const fs::path run = find_run(studio.folder, request.matches[1]);
    const std::scoped_lock lock(studio.starting);
    if (job::is_at_work(run)) {
        throw Refusal(409, "this run is at work");
    }
    const fs::path log = studio.folder / "cases" / run.filename() / "log.txt";
    io::make_folders(log.parent_path());
    fs::remove(work_folder(run) / "progress.json"); // of the call before
    start_and_watch(studio, {"resume", run.filename().string()}, run, log);
    answer(response, 201, {{"run", run.filename().string()}});
}

} // namespace

void add_case_routes(httplib::Server& server, Studio& studio) {
    server.Get("/api/examples", [&](const auto&, auto& response) {
        answer(response, 200, {{"result", studio.examples}});
    });
    server.Get("/api/keys", [&](const auto&, auto& response) {
        answer_call(response, call_program({"schema"}, studio.folder));
    });
    server.Get("/api/results", [&](const auto&, auto& response) {
        answer_call(response, call_program({"schema", "--results"}, studio.folder));
    });
    server.Post("/api/new", make_case);
    server.Post("/api/check", check);
    server.Post("/api/record", read_record);
    server.Post("/api/plan", [&](const auto& request, auto& response) { plan(request, response, studio); });
    server.Post("/api/start", [&](const auto& request, auto& response) { start(request, response, studio); });
    server.Post("/api/runs/([^/]+)/resume", [&](const auto& request, auto& response) {
        resume(request, response, studio);
    });
}

} // namespace suffuse::studio
