#pragma once
// What ParaView is given: grains, contacts, pores, the cell's outline, and the collection over time. Grains are brought
// home into the cell; what belongs to the first of them goes with it and may stick out.

#include "suffuse/dem/world.hpp"
#include "suffuse/io/vtk_writer.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::io {

/// Grains as points with `radius`, `id`, `fine`, `coordination`, `velocity` and further columns, a row a grain in
/// storage order (fluid force, pass of removal).
void write_grains_vtp(const std::filesystem::path& path, const dem::World& world, std::vector<VtkArray> further = {});

/// Contacts as lines between centers with `normal_force` (compression positive), `shear_force` [N], `overlap` [m].
void write_contacts_vtp(const std::filesystem::path& path, const dem::World& world);

/// Pores as tetrahedra, given by their corners [m], with columns of a row each.
void write_pores_vtu(
    const std::filesystem::path& path, const std::vector<std::array<Vec3, 4>>& pores, std::vector<VtkArray> columns
);

/// The twelve edges of the cell.
void write_cell_vtp(const std::filesystem::path& path, const cell::Cell& cell);

/// One file of a time series.
struct VtkFrame {
    double time = 0;  ///< [s]
    std::string file; ///< relative to the collection
    int part = 0;     ///< files of the same time are distinguished by it
};

void write_pvd(const std::filesystem::path& path, const std::vector<VtkFrame>& frames);

} // namespace suffuse::io
