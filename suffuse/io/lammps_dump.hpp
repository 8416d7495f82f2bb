#pragma once
// LAMMPS dump files of spheres (`dump custom`): the last frame, with its box. Columns x y z (or xu yu zu, or scaled xs
// ys zs), radius or diameter; optional vx vy vz and omegax omegay omegaz.

#include "suffuse/io/packing_file.hpp"

#include <string_view>

namespace suffuse::io {

[[nodiscard]] bool looks_like_lammps_dump(std::string_view text);

/// Positions are relative to the corner of the box. @throws CaseError with file and line.
ImportedPacking
parse_lammps_dump(const std::string& file, std::string_view text, double density, std::optional<double> radius = {});

} // namespace suffuse::io
