#include "suffuse/job/scene_states.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/record/known_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::job {
namespace {

using report::Scene;
using report::SceneState;

void add_contacts(const dem::World& world, const RowOf& rows, SceneState& state) {
    const Mat3 inverse_h = inverse(state.h);
    for (const dem::ContactView& view : dem::inspect_contacts(world)) {
        report::SceneContact contact;
        contact.i = rows.at(world.grains.id[view.i]);
        contact.j = rows.at(world.grains.id[view.j]);
        contact.normal_force = -dot(view.normal_force, view.normal);
        const double distance = world.grains.radius[view.i] + world.grains.radius[view.j] - view.overlap;
        const Vec3 touched = state.position[contact.i] + distance * view.normal;
        const Vec3 periods = inverse_h * (touched - state.position[contact.j]);
        for (int a = 0; a < 3; ++a) {
            contact.period[static_cast<std::size_t>(a)] = std::clamp(static_cast<int>(std::lround(periods[a])), -1, 1);
        }
        state.contacts.push_back(contact);
    }
}

} // namespace

RowOf rows_of(const Scene& scene) {
    RowOf rows;
    for (std::uint32_t row = 0; row < scene.id.size(); ++row) {
        rows.emplace(scene.id[row], row);
    }
    return rows;
}

std::uint32_t row_of(const RowOf& rows, std::uint32_t id, const std::filesystem::path& file) {
    const auto found = rows.find(id);
    if (found == rows.end()) {
        record::KnownState(file).complain(fmt::format("names the grain {}, which the stage did not start with", id));
    }
    return found->second;
}

dem::World load_state(const std::filesystem::path& state) {
    return record::KnownState(state).load().world;
}

SceneState
describe_state(const dem::World& world, const std::filesystem::path& file, const Scene& scene, const RowOf& rows) {
    SceneState state;
    state.h = world.cell.h;
    state.position.resize(scene.id.size());
    state.coordination.resize(scene.id.size());
    const Mat3 inverse_h = inverse(world.cell.h);
    const std::vector<int> coordination = dem::coordination(world);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const std::uint32_t row = row_of(rows, world.grains.id[g], file);
        state.position[row] = cell::wrapped(world.cell.h, inverse_h, world.grains.position[g]);
        state.coordination[row] = coordination[g];
    }
    add_contacts(world, rows, state);
    return state;
}

} // namespace suffuse::job
