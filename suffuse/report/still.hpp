#pragma once
// A still picture of a scene, drawn without a browser: spheres in parallel projection, lit from the upper left, coarse
// grains in sand, fines in red, inside the outline of the cell. For print, for pages whose 3D view cannot run, and for
// readers who want a PNG.

#include "suffuse/report/scene.hpp"

#include <string>

namespace suffuse::report {

/// PNG [ISO 15948] of `pixels` x `pixels` on transparent ground. All states of a scene are drawn to the same scale.
std::string still_picture(const Scene& scene, const SceneState& state, int pixels = 640);

/// The same indexed picture as a PNG: `index` row by row from the top, `palette` as red, green, blue, opacity, at most
/// 256 of them.
std::string png_of(
    int width, int height, const std::vector<std::uint8_t>& index,
    const std::vector<std::array<std::uint8_t, 4>>& palette
);

} // namespace suffuse::report
