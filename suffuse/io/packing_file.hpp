#pragma once
// Packings brought from other programs, as their files have them: tables with the columns x, y, z, r and optionally vx,
// vy, vz, wx, wy, wz, CSV (ParaView's too) or Yade's text; LAMMPS data files of atom_style sphere and dumps; extended
// XYZ; VTK's .vtp, .vtu and .vtk; MercuryDPM's .data and .restart. Plain or gzipped; lengths in m unless specified
// otherwise, velocities in m/s and rad/s.

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
    std::string no_cell;               ///< why not, where there is a box that is not periodic
    std::vector<std::string> warnings; ///< what was read but not used
};

/// Reads a packing, whichever of the formats it is, for grains of `density` [kg/m3]. Throws IoError where the file
/// cannot be read, CaseError with file and line where its content makes no sense.
/// @param unit what a length of 1 in the file stands for [m]
/// @param radius of all grains, for a file that has none [m]
ImportedPacking
read_packing(const std::filesystem::path& path, double density, double unit = 1, std::optional<double> radius = {});

} // namespace suffuse::io
