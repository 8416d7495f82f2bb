#pragma once
// An invented scene for tests of the report only: grains on a simple cubic lattice that touch their neighbors, across
// the faces of a leaning cell too; every third fine grain leaves in pass 1.

#include "suffuse/report/scene.hpp"

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

} // namespace suffuse::test
