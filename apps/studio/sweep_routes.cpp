// The samples of a sweep as tasks of a cluster: written by `suffuse sweep --emit slurm`, gathered by `--collect`.

#include "suffuse/base/read_text.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/run_folder.hpp"

#include "apps/studio/routes.hpp"
#include "apps/studio/run_folders.hpp"

namespace suffuse::studio {
namespace {

namespace fs = std::filesystem;

ProgramCall emit(
    const httplib::Request& request, const fs::path& folder, const std::string& subject,
    const std::vector<std::string>& more
) {
    std::vector<std::string> words{"sweep", subject, "--emit=slurm"};
    words.insert(words.end(), more.begin(), more.end());
    add_options(request, {"threads", "time-limit"}, words);
    return call_program(words, folder);
}

/// The run's name and its script, where the call has written one.
void answer_script(httplib::Response& response, const ProgramCall& call, const fs::path& run) {
    const fs::path script = run / "sweep.sbatch";
    if (call.code != 0) {
        answer_call(response, call);
        return;
    }
    if (!call.document.is_object()) { // there was nothing to write
        throw Refusal(409, "every sample of this run is done");
    }
    answer(
        response, 201,
        {{"run", run.filename().string()},
         {"tasks", call.document.value("tasks", 0)},
         {"script", as_utf8(read_whole_file(script.string()))},
         {"command", call.document.value("command", "")}}
    );
}

/// A new folder with the tasks of a case. The case is tried in a private folder first: one with an error leaves
/// nothing.
void emit_case(const httplib::Request& request, httplib::Response& response, const Studio& studio) {
    const std::string name = folder_name(field(request, "name"));
    std::vector<std::string> preset;
    add_options(request, {"preset"}, preset);
    const auto words = [&](const std::string& output) {
        std::vector<std::string> all = preset;
        all.push_back("--output=" + output);
        return all;
    };
    {
        const ScratchFolder scratch;
        take_case(request, scratch.path());
        const ProgramCall trial = emit(request, scratch.path(), "case.toml", words("run"));
        if (trial.code != 0) {
            answer_call(response, trial);
            return;
        }
    }
    const fs::path run = make_numbered_folder(studio.folder, name);
    const fs::path folder = fs::path("cases") / run.filename();
    io::make_folders(studio.folder / folder);
    take_case(request, studio.folder / folder);
    answer_script(
        response, emit(request, studio.folder, (folder / "case.toml").string(), words(run.filename().string())), run
    );
}

/// The samples of a run that are not finished, as tasks.
void emit_rest(const httplib::Request& request, httplib::Response& response, const Studio& studio) {
    const fs::path run = find_run(studio.folder, request.matches[1]);
    if (job::is_at_work(run)) {
        throw Refusal(409, "this run is at work; stop it first");
    }
    answer_script(response, emit(request, studio.folder, run.string(), {}), run);
}

/// What the tasks have left so far: a summary and a report.
void collect(const httplib::Request& request, httplib::Response& response, const Studio& studio) {
    const fs::path run = find_run(studio.folder, request.matches[1]);
    ProgramCall call = call_program({"sweep", "--collect", run.string()}, studio.folder, std::chrono::minutes(5));
    const bool has_gathered = call.document.is_object() && call.document.contains("unfinished");
    call.code = has_gathered ? 0 : call.code; // samples that are missing or failed are among what was found
    answer_call(response, call);
}

} // namespace

void add_sweep_routes(httplib::Server& server, Studio& studio) {
    server.Post("/api/slurm", [&](const auto& request, auto& response) { emit_case(request, response, studio); });
    server.Post("/api/runs/([^/]+)/slurm", [&](const auto& request, auto& response) {
        emit_rest(request, response, studio);
    });
    server.Post("/api/runs/([^/]+)/collect", [&](const auto& request, auto& response) {
        collect(request, response, studio);
    });
}

} // namespace suffuse::studio
