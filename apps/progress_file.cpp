#include "apps/progress_file.hpp"

#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/own_file.hpp"
#include "suffuse/record/documents.hpp"

#include <fstream>
#include <iterator>
#include <string>

namespace suffuse::apps {
namespace {

using nlohmann::json;

constexpr std::chrono::milliseconds interval{1000};

json describe(const run::Progress& progress) {
    return {
        {"study", progress.study},
        {"sample", progress.sample},
        {"samples", progress.samples},
        {"samples_done", progress.samples_done},
        {"samples_failed", progress.samples_failed},
        {"stage", progress.stage},
        {"verb", progress.verb},
        {"stages", progress.stages},
        {"stages_done", progress.stages_done},
        {"part", progress.part},
        {"steps", progress.steps},
        {"stage_seconds", progress.stage_seconds},
        {"run_seconds", progress.run_seconds},
        {"particle_steps_per_second", progress.particle_steps_per_second},
        {"state", progress.state},
    };
}

run::Progress understand(const json& told) {
    run::Progress progress;
    told.at("study").get_to(progress.study);
    told.at("sample").get_to(progress.sample);
    told.at("samples").get_to(progress.samples);
    told.at("samples_done").get_to(progress.samples_done);
    told.at("samples_failed").get_to(progress.samples_failed);
    told.at("stage").get_to(progress.stage);
    told.at("verb").get_to(progress.verb);
    told.at("stages").get_to(progress.stages);
    told.at("stages_done").get_to(progress.stages_done);
    told.at("part").get_to(progress.part);
    told.at("steps").get_to(progress.steps);
    told.at("stage_seconds").get_to(progress.stage_seconds);
    told.at("run_seconds").get_to(progress.run_seconds);
    told.at("particle_steps_per_second").get_to(progress.particle_steps_per_second);
    progress.state = told.at("state");
    return progress;
}

} // namespace

void ProgressFile::show(const run::Progress& progress) {
    left_.see(progress);
    running_[progress.sample] = progress;
    if (progress.sample_ended) {
        running_.erase(progress.sample);
    }
    const auto now = std::chrono::steady_clock::now();
    if (progress.stage_finished || progress.sample_ended || now - written_ >= interval) {
        written_ = now;
        write(progress);
    }
}

void ProgressFile::write(const run::Progress& latest) const {
    const Range left = left_.left();
    json running = json::array();
    for (const auto& [number, progress] : running_) {
        running.push_back(describe(progress));
    }
    const json all{{"latest", describe(latest)}, {"running", running}, {"seconds_left", {left.least, left.most}}};
    io::show_file(path_, all.dump() + '\n'); // what cannot be shown stops no run
}

std::optional<Published> read_progress(const std::filesystem::path& folder) {
    io::require_regular(folder / progress_file);
    std::ifstream file(folder / progress_file);
    const json all = record::parse_json(std::string(std::istreambuf_iterator<char>(file), {}));
    try {
        Published published;
        published.latest = understand(all.at("latest"));
        for (const json& one : all.at("running")) {
            const run::Progress progress = understand(one);
            published.running[progress.sample] = progress;
        }
        published.left = {all.at("seconds_left").at(0), all.at("seconds_left").at(1)};
        return published;
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

} // namespace suffuse::apps
