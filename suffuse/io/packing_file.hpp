#pragma once
// Packings brought from other programs, as their files have them: packing_readers.hpp lists the formats. Plain or
// gzipped; lengths in m, velocities in m/s and rad/s, unless the headings or the caller say otherwise.

#include "suffuse/cell/cell.hpp"
#include "suffuse/grains/grains.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::io {

struct ImportedPacking {
    grains::Grains grains;             ///< in the order of the file; `id` counts from 0
    std::optional<cell::Cell> cell;    ///< where the file gives one; positions are then relative to its corner
    Vec3 origin;                       ///< of the file, where positions are relative to the corner of its box [m]
    std::string no_cell;               ///< why not, where there is a box that is not periodic
    std::vector<std::string> warnings; ///< what was read but not used
};

/// Reads a packing, whichever of the formats it is, for grains of `density` [kg/m3]. Throws IoError where the file
/// cannot be read, CaseError with file and line where its content makes no sense.
/// @param unit what a length of 1 stands for where the file names no unit [m]
/// @param radius of all grains, for a file that has none [m]
ImportedPacking
read_packing(const std::filesystem::path& path, double density, double unit = 1, std::optional<double> radius = {});

} // namespace suffuse::io
