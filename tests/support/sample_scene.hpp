#pragma once
// An invented scene for tests of the report only: grains on a simple cubic lattice that touch their neighbors, across
// the faces of a leaning cell too; every third fine grain leaves in pass 1. Another scene has fines that migrate.

#include "suffuse/report/scene.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::test {

inline constexpr int scene_edge = 8; ///< grains along each edge of the lattice

inline report::SceneState sample_state(const report::Scene& scene, const Mat3& h, int passes) {
    report::SceneState state;
    state.label = passes == 0 ? "before erosion" : "after pass " + std::to_string(passes);
    state.passes = passes;
    state.h = h;
    const auto row = [](int a, int b, int c) {
        const auto around = [](int k) { return (k + scene_edge) % scene_edge; };
        return static_cast<std::uint32_t>((around(c) * scene_edge + around(b)) * scene_edge + around(a));
    };
    for (int k = 0; k < scene_edge * scene_edge * scene_edge; ++k) {
        const Vec3 at{k % scene_edge + 0.5, k / scene_edge % scene_edge + 0.5, k / scene_edge / scene_edge + 0.5};
        state.position.push_back(h * (at / scene_edge));
        state.coordination.push_back(0);
        const bool probed = passes == 0 && scene.fine[static_cast<std::size_t>(k)] != 0;
        const double nothing = std::numeric_limits<double>::quiet_NaN();
        state.speed.push_back(probed ? 1e-6 * std::pow(10.0, k % 5) : nothing);
        state.fluid_force.push_back(probed ? 1e-9 * (1 + k % 7) : nothing);
    }
    if (passes > 0) {
        state.speed.clear();
        state.fluid_force.clear();
    }
    // Chains along the first lattice direction; the last grain of a chain touches the first one's image.
    for (int c = 0; c < scene_edge; ++c) {
        for (int b = 0; b < scene_edge; ++b) {
            for (int a = 0; a < scene_edge; ++a) {
                const std::uint32_t i = row(a, b, c), j = row(a + 1, b, c);
                const bool touches = (b + c) % 4 != 0; // the others rattle
                if (touches && is_present(scene, state, i) && is_present(scene, state, j)) {
                    state.contacts.push_back({i, j, {a + 1 == scene_edge ? 1 : 0, 0, 0}, 1e-3 * (1 + (b * c) % 9)});
                    ++state.coordination[i];
                    ++state.coordination[j];
                }
            }
        }
    }
    return state;
}

inline report::Scene sample_scene() {
    report::Scene scene;
    const double edge = 2e-4; ///< of the lattice [m]
    for (std::uint32_t k = 0; k < scene_edge * scene_edge * scene_edge; ++k) {
        const bool fine = k % 3 != 0;
        scene.id.push_back(10 + 2 * k);
        scene.radius.push_back(0.5 * edge);
        scene.fine.push_back(fine ? 1 : 0);
        scene.left_in.push_back(fine && k % 9 == 1 ? 1 : 0);
    }
    const double width = scene_edge * edge;
    const Mat3 h = from_columns({width, 0, 0}, {0.15 * width, width, 0}, {0, 0.1 * width, width});
    scene.states = {sample_state(scene, h, 0), sample_state(scene, h, 1)};
    scene.flow_direction = {0, 0, 1};
    scene.gradient = 0.05;
    scene.remark = "512 invented grains on a lattice.";
    return scene;
}

/// Four states of 36 fines in the 9 channels of a simple cubic skeleton, along which the water flows. The fines of a
/// channel touch and share a fate; those that still move in the last state have crossed the cell's face by then. From
/// state 2 on, two of the channel that leaves are gone, and the two behind them have come in.
inline report::Scene sample_migration_scene() {
    report::Scene scene;
    scene.fates = {"coarse", "stayed", "lodged elsewhere", "moving at the end", "left", "held: carries the skeleton"};
    constexpr int edge = 3, line = 4; // coarse grains along an edge, fines in a channel
    constexpr std::uint8_t fate_of[edge * edge] = {1, 2, 3, 4, 1, 2, 3, 1, 5};
    const double coarse = 5e-4, fine = 1e-4, width = 2 * edge * coarse; // radii and edge of the cell [m]
    std::vector<Vec3> first;
    std::vector<double> step; // from state to state [m]
    const auto add = [&](const Vec3& x, double radius, int fate, double move) {
        scene.id.push_back(10 + 2 * static_cast<std::uint32_t>(scene.id.size()));
        scene.radius.push_back(radius);
        scene.fine.push_back(fate == 0 ? 0 : 1);
        scene.fate.push_back(static_cast<std::uint8_t>(fate));
        scene.left_in.push_back(0);
        scene.entered_in.push_back(0);
        first.push_back(x);
        step.push_back(move);
    };
    for (int k = 0; k < edge * edge * edge; ++k) {
        const Vec3 at{k % edge + 0.5, k / edge % edge + 0.5, k / edge / edge + 0.5};
        add(2 * coarse * at, coarse, 0, 0);
    }
    for (int channel = 0; channel < edge * edge; ++channel) {
        const int fate = fate_of[channel];
        for (int k = 0; k < line; ++k) {
            const Vec3 at{width / 3 + 2 * fine * k, 2 * coarse * (channel % edge), 2 * coarse * (channel / edge)};
            const bool moves = fate == 2 || fate == 3 || fate == 4;
            add(at, fine, fate, moves ? 0.25 * width : 0);
            if (fate == 4) {
                (k < line / 2 ? scene.entered_in : scene.left_in).back() = 2;
            }
        }
    }
    for (int k = 0; k < 4; ++k) {
        report::SceneState& state = scene.states.emplace_back();
        state.passes = k;
        state.time = 0.5 * k;
        state.gradient = 0.2 * (1 + k / 2);
        state.label =
            "i = " + std::string(k < 2 ? "0.2" : "0.4") + ", " + std::to_string(k / 2) + (k % 2 ? ".5 s" : " s");
        state.h = diagonal({width, width, width});
        for (std::size_t g = 0; g < first.size(); ++g) {
            // Those that lodge elsewhere do so from state 2 on.
            const double x = first[g].x + step[g] * (scene.fate[g] == 2 ? std::min(k, 2) : k);
            state.position.push_back({std::fmod(x, width), first[g].y, first[g].z});
            state.period.push_back({static_cast<int>(x / width), 0, 0});
        }
        state.coordination.assign(first.size(), 0);
        for (std::uint32_t j = 1; j < first.size(); ++j) {
            const std::uint32_t i = j - 1;
            const bool is_free = scene.fate[j] > 1 && scene.fate[j] < 5 && scene.fate[i] == scene.fate[j];
            if (is_free && first[i].y == first[j].y && is_present(scene, state, i) && is_present(scene, state, j)) {
                const bool crosses = state.position[j].x < state.position[i].x;
                state.contacts.push_back({i, j, {crosses ? 1 : 0, 0, 0}, 1e-6 * scene.fate[j]});
                ++state.coordination[i];
                ++state.coordination[j];
            }
        }
    }
    scene.flow_direction = {1, 0, 0};
    scene.gradient = 0.4;
    scene.remark = "36 invented fines that migrate between 27 coarse grains.";
    return scene;
}

} // namespace suffuse::test
