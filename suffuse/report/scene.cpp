#include "suffuse/report/scene.hpp"

#include "suffuse/base/base64.hpp"
#include "suffuse/base/error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace suffuse::report {

namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "the page reads little-endian arrays");

template <class T>
json column(const char* type, const std::vector<T>& values) {
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    return {{"type", type}, {"data", base64(bytes)}};
}

json singles(const std::vector<double>& values) {
    return column("f32", std::vector<float>(values.begin(), values.end()));
}

template <class T>
std::vector<T> clipped(const std::vector<int>& values) {
    std::vector<T> out;
    for (const int value : values) {
        out.push_back(static_cast<T>(std::clamp<int>(value, 0, std::numeric_limits<T>::max())));
    }
    return out;
}

/// Fractions of the cell vectors, three a grain.
json place_column(const SceneState& state) {
    const Mat3 inverse_h = inverse(state.h);
    std::vector<std::uint16_t> parts;
    parts.reserve(3 * state.position.size());
    for (const Vec3& x : state.position) {
        const Vec3 s = inverse_h * x;
        for (int a = 0; a < 3; ++a) {
            parts.push_back(static_cast<std::uint16_t>(std::lround(65535 * std::clamp(s[a], 0.0, 1.0))));
        }
    }
    return column("u16", parts);
}

json period_column(const SceneState& state) {
    std::vector<std::int16_t> periods;
    for (const auto& [a, b, c] : state.period) {
        for (const int along : {a, b, c}) {
            periods.push_back(static_cast<std::int16_t>(along));
        }
    }
    return column("i16", periods);
}

json contact_columns(const SceneState& state) {
    std::vector<std::uint32_t> ends;
    std::vector<std::uint8_t> period;
    std::vector<float> force;
    for (const SceneContact& contact : state.contacts) {
        ends.push_back(contact.i);
        ends.push_back(contact.j);
        const auto [a, b, c] = contact.period;
        period.push_back(static_cast<std::uint8_t>(a + 1 + 3 * (b + 1) + 9 * (c + 1)));
        force.push_back(static_cast<float>(contact.normal_force));
    }
    const bool is_small = state.position.size() <= std::numeric_limits<std::uint16_t>::max();
    return {
        {"ends", is_small ? column("u16", std::vector<std::uint16_t>(ends.begin(), ends.end())) : column("u32", ends)},
        {"period", column("u8", period)},
        {"normal_force", column("f32", force)}};
}

} // namespace

SceneCount count_scene(const Scene& scene, const SceneState& state) {
    if (state.whole) {
        return *state.whole;
    }
    SceneCount count;
    for (std::size_t g = 0; g < scene.id.size(); ++g) {
        if (is_present(scene, state, g)) {
            ++count.grains;
            count.fines += scene.fine[g];
            count.rattlers += state.coordination[g] < 2 ? 1 : 0;
        }
    }
    count.contacts = std::ssize(state.contacts);
    for (const SceneContact& contact : state.contacts) {
        count.mean_force += contact.normal_force / static_cast<double>(state.contacts.size());
        count.largest_force = std::max(count.largest_force, contact.normal_force);
    }
    count.strong = std::count_if(state.contacts.begin(), state.contacts.end(), [&](const SceneContact& contact) {
        return contact.normal_force > count.mean_force;
    });
    return count;
}

void leave_out_weak_contacts(const Scene& scene, SceneState& state) {
    state.whole = count_scene(scene, state);
    std::erase_if(state.contacts, [&](const SceneContact& contact) {
        return contact.normal_force <= state.whole->mean_force;
    });
}

json scene_json(const Scene& scene) {
    json states = json::array();
    for (const SceneState& state : scene.states) {
        expects(
            state.position.size() == scene.id.size() && state.coordination.size() == scene.id.size(),
            "a state has a row for each grain of its scene"
        );
        json one = {
            {"label", state.label},
            {"passes", state.passes},
            {"cell",
             {{state.h(0, 0), state.h(1, 0), state.h(2, 0)},
              {state.h(0, 1), state.h(1, 1), state.h(2, 1)},
              {state.h(0, 2), state.h(1, 2), state.h(2, 2)}}}, // by cell vectors
            {"place", place_column(state)},
            {"coordination", column("u16", clipped<std::uint16_t>(state.coordination))},
            {"contacts", contact_columns(state)}};
        if (state.time) {
            one["time"] = *state.time;
            one["period"] = period_column(state);
        }
        if (state.gradient) {
            one["gradient"] = *state.gradient;
        }
        if (!state.speed.empty()) {
            one["speed"] = singles(state.speed);
        }
        if (!state.fluid_force.empty()) {
            one["fluid_force"] = singles(state.fluid_force);
        }
        if (!state.mobile_gradient.empty()) {
            one["mobile_gradient"] = singles(state.mobile_gradient);
        }
        states.push_back(std::move(one));
    }
    json all = {
        {"id", column("u32", scene.id)},
        {"radius", singles(scene.radius)},
        {"fine", column("u8", scene.fine)},
        {"left_in", column("u16", clipped<std::uint16_t>(scene.left_in))},
        {"flow_direction", {scene.flow_direction.x, scene.flow_direction.y, scene.flow_direction.z}},
        {"gradient", scene.gradient},
        {"states", std::move(states)}};
    if (!scene.entered_in.empty()) {
        all["entered_in"] = column("u16", clipped<std::uint16_t>(scene.entered_in));
    }
    if (!scene.fate.empty()) {
        all["fate"] = column("u8", scene.fate);
        all["fates"] = scene.fates;
    }
    return all;
}

} // namespace suffuse::report
