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

run::Progress understand(const json& stored) {
    run::Progress progress;
    stored.at("study").get_to(progress.study);
    stored.at("sample").get_to(progress.sample);
    stored.at("samples").get_to(progress.samples);
    stored.at("samples_done").get_to(progress.samples_done);
    stored.at("samples_failed").get_to(progress.samples_failed);
    stored.at("stage").get_to(progress.stage);
    stored.at("verb").get_to(progress.verb);
    stored.at("stages").get_to(progress.stages);
    stored.at("stages_done").get_to(progress.stages_done);
    stored.at("part").get_to(progress.part);
    stored.at("steps").get_to(progress.steps);
    stored.at("stage_seconds").get_to(progress.stage_seconds);
    stored.at("run_seconds").get_to(progress.run_seconds);
    stored.at("particle_steps_per_second").get_to(progress.particle_steps_per_second);
    progress.state = stored.at("state");
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
