#pragma once
// Pictures of grains for ParaView and OVITO: what every state has, and what a stage knows of them beyond that.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/result.hpp"
#include "suffuse/io/packing_export.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::run {

/// Writes the files of the formats, `stem`.vtp and `stem`.xyz: grains with their stress and mean stress [Pa],
/// the latter with their color in the report, too.
/// @param further columns, a row a grain
void write_grain_pictures(
    const std::filesystem::path& folder, const std::string& stem, const dem::World& world,
    const std::vector<std::string>& formats, const std::vector<io::GrainColumn>& further = {}
);

/// A vector a grain.
io::GrainColumn picture_column(std::string name, const std::vector<Vec3>& values);

/// What a probe saw of the fines: `probe_fluid_force` [N], `probe_speed` at its end [m/s]; not a number for grains that
/// it did not see.
std::vector<io::GrainColumn> probe_columns(const dem::World& world, const erosion::ProbeResult& probe);

} // namespace suffuse::run
