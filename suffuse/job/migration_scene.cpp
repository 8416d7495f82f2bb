#include "suffuse/job/migration_scene.hpp"

#include "suffuse/base/grouped.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/job/scene_states.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;
using report::Scene;
using report::SceneState;

fs::path place_of(const fs::path& folder, const record::FinishedStage& stage) {
    return record::stage_folder(folder, *stage.variant, *stage.stage);
}

/// Enters all grains of all frames, and when each is there.
void add_grains(const std::vector<dem::World>& frames, Scene& scene) {
    struct Seen {
        double radius = 0;
        std::uint8_t fine = 0;
        int first = 0, last = 0;
    };

    std::map<std::uint32_t, Seen> seen; // by id
    for (int frame = 0; frame < std::ssize(frames); ++frame) {
        const grains::Grains& grains = frames[static_cast<std::size_t>(frame)].grains;
        for (std::size_t g = 0; g < grains.size(); ++g) {
            const Seen now{grains.radius[g], grains.fine[g], frame, frame};
            seen.try_emplace(grains.id[g], now).first->second.last = frame;
        }
    }
    const int end = static_cast<int>(std::ssize(frames)) - 1;
    for (const auto& [id, grain] : seen) {
        scene.id.push_back(id);
        scene.radius.push_back(grain.radius);
        scene.fine.push_back(grain.fine);
        scene.entered_in.push_back(grain.first);
        scene.left_in.push_back(grain.last < end ? grain.last + 1 : 0);
    }
}

/// In the order of Whereabouts, behind coarse grains.
const std::vector<std::string> fate_names = {
    "coarse", "stayed", "lodged elsewhere", "moving at the end", "left", "held: carries the skeleton"};

void add_fates(const erosion::MigrationFates& found, const RowOf& rows, Scene& scene) {
    scene.fates = fate_names;
    scene.fate.assign(scene.id.size(), 0);
    for (std::size_t k = 0; k < found.id.size(); ++k) {
        if (const auto row = rows.find(found.id[k]); row != rows.end()) { // else it came and left between two frames
            scene.fate[row->second] = static_cast<std::uint8_t>(1 + static_cast<int>(found.where[k]));
        }
    }
}

/// Brings the forces of free grains to their true size, and leaves the contacts of the skeleton out; what is counted is
/// still of all.
void keep_free_contacts(
    const dem::World& world, const RowOf& rows, double weight_scale, const Scene& scene, SceneState& state
) {
    std::vector<bool> is_free(state.position.size());
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        is_free[rows.at(world.grains.id[g])] = world.grains.motion[g] != grains::Motion::Held;
    }
    const auto is_of_free = [&](const report::SceneContact& contact) {
        return is_free[contact.i] || is_free[contact.j];
    };
    for (report::SceneContact& contact : state.contacts) {
        contact.normal_force /= is_of_free(contact) ? weight_scale : 1;
    }
    state.whole = report::count_scene(scene, state);
    std::erase_if(state.contacts, std::not_fn(is_of_free));
}

/// Grains are not wrapped: their places say how often they crossed a face.
void add_periods(const dem::World& world, const RowOf& rows, SceneState& state) {
    const Mat3 inverse_h = inverse(state.h);
    state.period.resize(state.position.size());
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const cell::Image period = cell::period_of(inverse_h, world.grains.position[g]);
        state.period[rows.at(world.grains.id[g])] = {period.a, period.b, period.c};
    }
}

} // namespace

const record::FinishedStage*
watched_migration(const fs::path& folder, const std::vector<record::FinishedStage>& stages) {
    const auto found = std::ranges::find_if(stages, [&](const record::FinishedStage& stage) {
        const auto& migration = stage.findings.migration;
        return migration && !migration->frames.empty() &&
               fs::exists(record::frame_file(place_of(folder, stage), migration->frames.size() - 1));
    });
    return found == stages.end() ? nullptr : &*found;
}

Scene scene_of_frames(const std::vector<dem::World>& frames, const erosion::MigrationResult& migration) {
    Scene scene;
    add_grains(frames, scene);
    const RowOf rows = rows_of(scene);
    add_fates(migration.fates, rows, scene);
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const erosion::MigrationFrame& frame = migration.frames[k];
        SceneState state = describe_state(frames[k], {}, scene, rows);
        state.label = k == 0 ? "at rest, before the flow"
                             : fmt::format("i = {:g}, {}\u00a0s", frame.gradient, short_number(frame.time, 3));
        state.passes = static_cast<int>(k);
        state.time = frame.time;
        state.gradient = frame.gradient;
        add_periods(frames[k], rows, state);
        keep_free_contacts(frames[k], rows, frame.weight_scale, scene, state);
        scene.gradient = std::max(scene.gradient, frame.gradient);
        scene.states.push_back(std::move(state));
    }
    return scene;
}

Scene scene_of_migration(const fs::path& folder, const record::FinishedStage& stage) {
    const erosion::MigrationResult& migration = *stage.findings.migration;
    std::vector<dem::World> frames;
    for (std::size_t k = 0; k < migration.frames.size(); ++k) {
        frames.push_back(load_state(record::frame_file(place_of(folder, stage), k)));
    }
    Scene scene = scene_of_frames(frames, migration);
    scene.flow_direction = std::get<erosion::MigrateSpec>(stage.stage->spec).direction;
    scene.remark = fmt::format(
        "The {} grains of {} at {} times. Contacts are those of fines that are free to move. "
        "Paths join their places at these times by straight lines.",
        grouped(std::ssize(scene.id)), study::in_words_of_sample(stage), scene.states.size()
    );
    return scene;
}

} // namespace suffuse::job
