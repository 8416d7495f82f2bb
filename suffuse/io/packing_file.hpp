#pragma once
// Packings brought from other programs: CSV with the columns x, y, z, r and optionally vx, vy, vz, wx, wy, wz; Yade's
// `x y z r` text; LAMMPS data files of atom_style sphere and dumps; extended XYZ; VTK's .vtp. Plain or gzipped; lengths
// in m unless told otherwise, velocities in m/s and rad/s.

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
    std::vector<std::string> warnings; ///< what was read but not used
};

/// Reads a packing, whichever of the formats it is, for grains of `density` [kg/m3]. Throws IoError where the file
/// cannot be read, CaseError with file and line where its content makes no sense.
/// @param unit what a length of 1 in the file stands for [m]
ImportedPacking read_packing(const std::filesystem::path& path, double density, double unit = 1);

/// What to say of grains of a size that no soil has, which is what a file in mm looks like; nothing of others.
std::optional<std::string> size_warning(const grains::Grains& grains, const std::string& origin);

/// What to say of a cell so narrow that results depend on it; nothing of one that is wide enough.
std::optional<std::string> narrow_cell_warning(const grains::Grains& grains, const Mat3& h, const std::string& origin);

/// Largest overlap of two grains over the smaller radius [-]. Throws CaseError, naming the worst pair, where it exceeds
/// `share`, and the grain whose position lies too far from the cell; `origin` is the file that the grains come from.
double check_overlaps(
    const grains::Grains& grains, const cell::Cell& cell, double share, const std::string& origin = "packing"
);

} // namespace suffuse::io
