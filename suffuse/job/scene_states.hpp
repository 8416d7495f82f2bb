#pragma once
// From states on disk to those of a scene: what every view in 3D has, whatever it shows.

#include "suffuse/dem/world.hpp"
#include "suffuse/report/scene.hpp"

#include <cstdint>
#include <filesystem>
#include <unordered_map>

namespace suffuse::job {

/// Row of a grain of the scene by its id.
using RowOf = std::unordered_map<std::uint32_t, std::uint32_t>;

RowOf rows_of(const report::Scene& scene);

/// @throws IoError where `file` names a grain that the scene does not have.
std::uint32_t row_of(const RowOf& rows, std::uint32_t id, const std::filesystem::path& file);

dem::World load_state(const std::filesystem::path& state);

/// Places, coordination and contacts. @param file that holds `world`
report::SceneState describe_state(
    const dem::World& world, const std::filesystem::path& file, const report::Scene& scene, const RowOf& rows
);

} // namespace suffuse::job
