#pragma once
// Packings for other programs. All three print numbers so that reading them back gives the same bits; lengths in m.

#include "suffuse/cell/cell.hpp"
#include "suffuse/grains/grains.hpp"

#include <filesystem>

namespace suffuse::io {

/// CSV with the columns x, y, z, r, vx, vy, vz, wx, wy, wz, as `read_packing` takes it.
void export_csv(const std::filesystem::path& path, const grains::Grains& grains);

/// `x y z r` text, as Yade's ymport.text takes it.
void export_yade(const std::filesystem::path& path, const grains::Grains& grains);

/// Extended XYZ with the cell, for OVITO and ASE: grains brought home into the cell.
void export_extended_xyz(const std::filesystem::path& path, const grains::Grains& grains, const cell::Cell& cell);

} // namespace suffuse::io
