#include "suffuse/job/scene_data.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/job/migration_scene.hpp"
#include "suffuse/job/scene_states.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/study/trace_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::job {
namespace {

using report::Scene;
using report::SceneState;

constexpr std::size_t most_rows = 400'000;     ///< grains x states in a page: beyond, only the first and last state
constexpr std::size_t most_contacts = 300'000; ///< of a state in a page: beyond, only those above the mean force
constexpr std::size_t most_stages = 4;         ///< shown of a run without erosion

/// The columns that do not change, with a row a grain in order of id.
void add_grains(const dem::World& world, Scene& scene) {
    std::vector<std::uint32_t> order(world.grains.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return world.grains.id[a] < world.grains.id[b];
    });
    for (const std::uint32_t g : order) {
        scene.id.push_back(world.grains.id[g]);
        scene.radius.push_back(world.grains.radius[g]);
        scene.fine.push_back(world.grains.fine[g]);
    }
    scene.left_in.assign(order.size(), 0);
}

/// What the probe of a pass saw of each fine grain.
void add_probe(const erosion::ProbeResult& probe, const RowOf& rows, SceneState& state) {
    if (probe.id.empty()) {
        return;
    }
    state.speed.assign(state.position.size(), std::numeric_limits<double>::quiet_NaN());
    state.fluid_force = state.speed;
    for (std::size_t k = 0; k < probe.id.size(); ++k) {
        if (const auto found = rows.find(probe.id[k]); found != rows.end()) {
            state.speed[found->second] = probe.speed[k].back();
            state.fluid_force[found->second] = probe.fluid_force[k];
        }
    }
}

/// The gradient that first moved each fine grain of the state.
void add_mobility(const erosion::MobilityResult& mobility, const RowOf& rows, SceneState& state) {
    state.mobile_gradient.assign(state.position.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < mobility.id.size(); ++k) {
        if (const auto found = rows.find(mobility.id[k]); found != rows.end()) {
            state.mobile_gradient[found->second] = mobility.mobile_gradient[k];
        }
    }
}

/// Keeps the page to a size that opens quickly, and says what was left out.
void limit_size(Scene& scene) {
    if (scene.states.size() > 2 && scene.states.size() * scene.id.size() > most_rows) {
        scene.remark += fmt::format(
            " Of {} states the first and the last are shown, to keep this file small.", scene.states.size()
        );
        scene.states.erase(scene.states.begin() + 1, scene.states.end() - 1);
    }
    for (SceneState& state : scene.states) {
        if (state.contacts.size() <= most_contacts) {
            continue;
        }
        report::leave_out_weak_contacts(scene, state);
        scene.remark += fmt::format(
            " {}: the view has only the contacts above the mean force, the table counts all.", as_sentence(state.label)
        );
    }
}

/// The state after a pass: a file of its own, or that of its stage.
std::filesystem::path file_after(const std::filesystem::path& folder, const study::StagePass& made) {
    const std::filesystem::path place = record::stage_folder(folder, *made.stage->variant, *made.stage->stage);
    return made.is_last ? place / "state.h5" : record::pass_file(place, made.number);
}

Scene scene_of_erosion(const std::filesystem::path& folder, const study::ErosionStory& story) {
    Scene scene;
    const record::FinishedStage& eroded = *story.eroded;
    const erosion::ErosionResult& erosion = story.erosion;
    const std::filesystem::path place = record::stage_folder(folder, *eroded.variant, *eroded.stage);
    const auto& parent = eroded.variant->stages[static_cast<std::size_t>(eroded.stage->parent)];
    const dem::World before = load_state(record::stage_folder(folder, *eroded.variant, parent) / "state.h5");
    add_grains(before, scene);
    const RowOf rows = rows_of(scene);
    for (const erosion::LedgerRow& row : erosion.ledger) {
        scene.left_in[row_of(rows, row.grain, place / "results.cbor")] = row.pass;
    }
    if (const auto* spec = std::get_if<erosion::ErodeSpec>(&eroded.stage->spec); spec != nullptr && !spec->forced) {
        scene.flow_direction = spec->direction;
        scene.gradient = spec->gradient;
    }
    const int passes = static_cast<int>(erosion.passes.size());
    for (int pass = 0; pass <= passes; ++pass) {
        const std::filesystem::path file =
            pass == 0 ? place : file_after(folder, story.made_in[static_cast<std::size_t>(pass) - 1]);
        if (pass > 0 && !std::filesystem::exists(file)) {
            continue; // a run of an earlier version
        }
        SceneState state = describe_state(pass == 0 ? before : load_state(file), file, scene, rows);
        state.label = pass == 0 ? "before erosion" : fmt::format("after pass {}", pass);
        state.passes = pass;
        if (pass < passes) {
            const erosion::PassResult& next = erosion.passes[static_cast<std::size_t>(pass)];
            add_probe(next.probe, rows, state);
            if (next.mobility) {
                add_mobility(*next.mobility, rows, state);
            }
        }
        scene.states.push_back(std::move(state));
    }
    scene.remark =
        fmt::format("The {} grains of {}.", grouped(std::ssize(scene.id)), study::in_words_of_sample(eroded));
    if (scene.gradient > 0) {
        scene.remark += fmt::format(
            " Speed and fluid force are those of the fines in the probe of the pass that follows, under i = {:g}.",
            scene.gradient
        );
    }
    return scene;
}

/// The last stage of the sample to show: of the mixtures of the last study the one nearest to where fines begin to
/// carry, for pure sand and pure fines show nothing of it.
const record::FinishedStage& shown_stage(const std::vector<record::FinishedStage>& stages) {
    constexpr double typical_content = 0.3;
    const auto distance = [](const record::FinishedStage& stage) {
        const auto& soil = stage.variant->soil;
        const bool is_mixture = soil && soil->fines && soil->fines_content > 0 && soil->fines_content < 1;
        return is_mixture ? std::abs(soil->fines_content - typical_content) : 1.0;
    };
    const record::FinishedStage* shown = &stages.back();
    for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage) {
        if (stage->study == shown->study && distance(*stage) < distance(*shown)) {
            shown = &*stage;
        }
    }
    return *shown;
}

/// The stages of the sample of `last` with as many grains as it has, in the case's order; clouds, which touch nowhere,
/// left out. A scene has one list of grains.
std::vector<const casefile::Stage*>
stages_to_show(const std::vector<record::FinishedStage>& finished, const record::FinishedStage& last) {
    std::vector<const casefile::Stage*> shown;
    for (const record::FinishedStage& each : finished) {
        const bool is_cloud = casefile::traits_of(*each.stage).origin == casefile::Origin::Soil;
        if (each.variant == last.variant && !is_cloud && each.stage <= last.stage &&
            each.numbers.at("grains") == last.numbers.at("grains")) {
            shown.push_back(each.stage);
        }
    }
    std::sort(shown.begin(), shown.end());
    if (shown.size() > most_stages) {
        shown.erase(shown.begin(), shown.end() - most_stages);
    }
    return shown;
}

Scene scene_of_stages(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& finished,
    const record::FinishedStage& last
) {
    Scene scene;
    RowOf rows;
    for (const casefile::Stage* stage : stages_to_show(finished, last)) {
        const std::filesystem::path file = record::stage_folder(folder, *last.variant, *stage) / "state.h5";
        const dem::World world = load_state(file);
        if (scene.id.empty()) {
            add_grains(world, scene);
            rows = rows_of(scene);
        }
        SceneState state = describe_state(world, file, scene, rows);
        state.label = fmt::format("after {}", stage->name);
        const auto of_stage = std::ranges::find_if(finished, [&](const record::FinishedStage& each) {
            return each.variant == last.variant && each.stage == stage;
        });
        if (of_stage != finished.end() && of_stage->findings.mobility) {
            add_mobility(*of_stage->findings.mobility, rows, state);
        }
        scene.states.push_back(std::move(state));
    }
    scene.remark = fmt::format("The {} grains of {}.", grouped(std::ssize(scene.id)), study::in_words_of_sample(last));
    return scene;
}

} // namespace

Scene scene_of_world(const dem::World& world, const std::string& label) {
    Scene scene;
    add_grains(world, scene);
    scene.states.push_back(describe_state(world, {}, scene, rows_of(scene)));
    scene.states.back().label = label;
    limit_size(scene);
    return scene;
}

Scene describe_scene(
    const std::filesystem::path& folder, const std::vector<record::FinishedStage>& stages,
    const study::ErosionStory& story
) {
    Scene scene;
    if (const record::FinishedStage* migration = watched_migration(folder, stages)) {
        scene = scene_of_migration(folder, *migration);
    } else if (story.eroded != nullptr && story.eroded->stage->parent >= 0) {
        scene = scene_of_erosion(folder, story);
    } else if (!stages.empty()) {
        scene = scene_of_stages(folder, stages, shown_stage(stages));
    }
    limit_size(scene);
    return scene;
}

} // namespace suffuse::job
