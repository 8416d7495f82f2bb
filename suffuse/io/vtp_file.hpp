#pragma once
// Grains out of VTK's XML PolyData or UnstructuredGrid (`.vtp`, `.vtu`) and its legacy files (`.vtk`): points, a point
// array `radius` (or `diameter`), perhaps `velocity`, `angular_velocity` and `fine`, and the cell in the field array
// `cell` (nine numbers, vector after vector) as we write it. Arrays as ASCII, base64 or raw appended, plain or
// compressed with zlib: what ParaView and Yade save. [VTK file formats]

#include "suffuse/io/packing_file.hpp"

#include <string_view>

namespace suffuse::io {

[[nodiscard]] bool looks_like_vtp(std::string_view text);

/// @throws CaseError, naming the array.
ImportedPacking
parse_vtp(const std::string& file, std::string_view text, double density, std::optional<double> radius = {});

} // namespace suffuse::io
