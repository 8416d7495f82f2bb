#pragma once
// LAMMPS data files of atom_style sphere: header, box (sheared too), Atoms and Velocities. [LAMMPS manual, read_data]

#include "suffuse/io/packing_file.hpp"

#include <string>
#include <string_view>

namespace suffuse::io {

/// Whether the head of a text says how many atoms there are, as a data file does.
bool looks_like_lammps(std::string_view text);

ImportedPacking
parse_lammps(const std::string& file, std::string_view text, double density, std::optional<double> radius = {});

} // namespace suffuse::io
