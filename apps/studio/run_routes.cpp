// The runs of the folder: the list, one of them, its files, two compared; stopped, printed, removed.

#include "suffuse/base/read_text.hpp"
#include "suffuse/job/calibration_files.hpp"
#include "suffuse/job/calibration_folder.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/folder.hpp"

#include "apps/studio/door.hpp"
#include "apps/studio/routes.hpp"
#include "apps/studio/run_folders.hpp"
#include "apps/studio/shared_call.hpp"
#include <array>
#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

namespace suffuse::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t most_served = std::uintmax_t{1} << 30; ///< of a file of a run [B]

/// A JSON file of a run; null where there is none, or it cannot be understood.
json read_of(const fs::path& run, const char* name) {
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(run / name, error))) {
        return nullptr;
    }
    json read = json::parse(read_whole_file((run / name).string()), nullptr, false);
    return read.is_discarded() ? json(nullptr) : read;
}

json events_of(const fs::path& run) {
    json events = json::array();
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(run / "events.jsonl", error))) {
        return events;
    }
    std::istringstream lines(read_whole_file((run / "events.jsonl").string()));
    for (std::string line; std::getline(lines, line);) {
        if (json event = json::parse(line, nullptr, false); !event.is_discarded()) {
            events.push_back(std::move(event));
        }
    }
    return events;
}

/// The rounds of a calibration, and when its answer was written; null for another run.
json calibration_in(const fs::path& run) {
    if (!job::is_calibration(run)) {
        return nullptr;
    }
    json rounds = json::array();
    for (const fs::path& round : job::rounds_of(run)) {
        const json plan = read_of(round, "plan.json"),
                   stages = plan.is_object() ? plan.value("stages", json()) : json();
        rounds.push_back(
            {{"name", round.filename().string()}, {"stages", stages.size()}, {"done", finished_stages(round).size()}}
        );
    }
    json found{{"rounds", rounds}, {"answered", nullptr}};
    std::error_code error;
    if (const auto written = fs::last_write_time(run / job::calibration_file, error); !error) {
        found["answered"] = written.time_since_epoch().count();
    }
    return found;
}

void show_run(const httplib::Request& request, httplib::Response& response, const Studio& studio) {
    const fs::path run = find_run(studio.folder, request.matches[1]), work = work_folder(run);
    const bool is_at_work = job::is_at_work(run); // before the events: what ends meanwhile has written its last
    answer(
        response, 200,
        {{"name", run.filename().string()},
         {"at_work", is_at_work},
         {"can_stop", is_at_work && process_of(run).has_value()},
         {"can_delete", !is_at_work && fs::is_regular_file(run / record::provenance_file)},
         {"progress", read_of(work, "progress.json")},
         {"plan", read_of(work, "plan.json")},
         {"events", events_of(work)},
         {"calibration", calibration_in(run)},
         {"done", finished_stages(run)},
         {"last_words", is_at_work ? "" : last_words(studio.folder / "cases" / run.filename() / "log.txt")},
         {"tasks", fs::is_regular_file(fs::symlink_status(run / "sweep.sbatch"))},
         {"report", fs::is_regular_file(run / "report.html")}}
    );
}

const char* type_of(const fs::path& file) {
    constexpr std::array<std::pair<const char*, const char*>, 8> types = {{
        {".html", "text/html; charset=utf-8"},
        {".json", "application/json; charset=utf-8"},
        {".csv", "text/csv; charset=utf-8"},
        {".toml", "text/plain; charset=utf-8"},
        {".pdf", "application/pdf"},
        {".svg", "image/svg+xml"},
        {".png", "image/png"},
        {".txt", "text/plain; charset=utf-8"},
    }};
    for (const auto& [ending, type] : types) {
        if (file.extension() == ending) {
            return type;
        }
    }
    return "application/octet-stream";
}

void show_file(const httplib::Request& request, httplib::Response& response, const Studio& studio) {
    const fs::path run = find_run(studio.folder, request.matches[1]);
    const fs::path file = find_below(run, request.matches[2]);
    if (!fs::is_regular_file(file) || fs::file_size(file) > most_served) {
        throw Refusal(404, "there is no such file in this run");
    }
    std::ifstream stream(file, std::ios::binary);
    std::string content(fs::file_size(file), '\0');
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    content.resize(static_cast<std::size_t>(stream.gcount()));
    response.set_header("Content-Security-Policy", sandbox_policy);
    set_plain_content(response, std::move(content), type_of(file));
}

} // namespace

void add_run_routes(httplib::Server& server, Studio& studio) {
    server.Get("/api/names", [&](const auto&, auto& response) {
        answer(response, 200, {{"result", run_names(studio.folder)}});
    });
    const auto list = std::make_shared<SharedCall>([&studio] {
        return call_program({"runs", studio.folder.string()}, studio.folder);
    });
    server.Get("/api/runs", [list](const auto&, auto& response) { answer_call(response, list->answer()); });
    server.Get("/api/runs/([^/]+)", [&](const auto& request, auto& response) { show_run(request, response, studio); });
    server.Get("/api/runs/([^/]+)/pictures", [&](const auto& request, auto& response) {
        json pictures = json::array();
        for (const GrainPicture& picture : grain_pictures(find_run(studio.folder, request.matches[1]))) {
            pictures.push_back({{"file", picture.file}, {"at", picture.written.time_since_epoch().count()}});
        }
        answer(response, 200, {{"result", pictures}});
    });
    server.Get("/runs/([^/]+)/(.+)", [&](const auto& request, auto& response) {
        show_file(request, response, studio);
    });
    server.Get("/api/compare/([^/]+)/([^/]+)", [&](const auto& request, auto& response) {
        const fs::path one = find_run(studio.folder, request.matches[1]);
        const fs::path other = find_run(studio.folder, request.matches[2]);
        ProgramCall call = call_program({"compare", one.string(), other.string()}, studio.folder);
        constexpr int differs = 5;
        call.code = call.code == differs ? 0 : call.code; // what was to be found out
        answer_call(response, call);
    });
    server.Post("/api/runs/([^/]+)/stop", [&](const auto& request, auto& response) {
        stop_run(find_run(studio.folder, request.matches[1]));
        answer(response, 202, json::object());
    });
    server.Post("/api/runs/([^/]+)/pdf", [&](const auto& request, auto& response) {
        const fs::path run = find_run(studio.folder, request.matches[1]);
        answer_call(response, call_program({"report", run.string(), "--pdf"}, studio.folder, std::chrono::minutes(5)));
    });
    server.Post("/api/runs/([^/]+)/delete", [&](const auto& request, auto& response) {
        remove_run(find_run(studio.folder, request.matches[1]));
        answer(response, 200, json::object());
    });
}

} // namespace suffuse::studio
