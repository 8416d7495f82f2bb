#pragma once
// Packings for other programs. All print numbers so that reading them back gives the same bits; lengths in m.

#include "suffuse/cell/cell.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/grains/grains.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

enum class PackingFormat { Csv, Yade, ExtendedXyz, LammpsData, LammpsDump, Vtp };

/// "csv", "yade", "xyz", "lammps", "dump", "vtp".
std::vector<std::string> packing_format_names();

/// The format of that name; nothing where there is none.
std::optional<PackingFormat> packing_format_of_name(std::string_view name);

/// The format that a file's ending shows: .csv, .txt (Yade), .xyz, .extxyz, .data, .lmp, .dump, .lammpstrj, .vtp.
std::optional<PackingFormat> packing_format_of_file(const std::filesystem::path& path);

/// Whether a file of that format needs the cell.
bool needs_cell(PackingFormat format);

/// Writes the grains of `world` in its order. @throws IoError; CaseError where the format cannot hold the cell.
void export_packing(const std::filesystem::path& path, const dem::World& world, PackingFormat format);

/// CSV with the columns x, y, z, r, vx, vy, vz, wx, wy, wz, as `read_packing` takes it.
void export_csv(const std::filesystem::path& path, const grains::Grains& grains);

/// `x y z r` text, as Yade's ymport.text takes it.
void export_yade(const std::filesystem::path& path, const grains::Grains& grains);

/// A further column of a picture of grains, row after row.
struct GrainColumn {
    std::string name;
    std::size_t components = 1;
    std::vector<double> values;
};

/// Extended XYZ with the cell, for OVITO and ASE: grains brought home into the cell.
void export_extended_xyz(
    const std::filesystem::path& path, const grains::Grains& grains, const cell::Cell& cell,
    const std::vector<GrainColumn>& further = {}
);

/// LAMMPS data file of atom_style sphere; type 2 are the fines. The first cell vector must point along x, the second
/// lie in the xy plane, as LAMMPS wants it.
void export_lammps_data(const std::filesystem::path& path, const grains::Grains& grains, const cell::Cell& cell);

/// One frame of a LAMMPS dump, likewise.
void export_lammps_dump(const std::filesystem::path& path, const dem::World& world);

/// ParaView's PolyData to the last bit, with the cell as a field array.
void export_vtp(const std::filesystem::path& path, const dem::World& world);

} // namespace suffuse::io
