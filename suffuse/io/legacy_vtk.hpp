#pragma once
// Legacy VTK files (.vtk) of points and their arrays, as LIGGGHTS, YADE and ParaView write them, ASCII or binary.
// [VTK file formats, simple legacy formats]

#include "suffuse/io/vtk_reader.hpp"

#include <map>
#include <string>
#include <string_view>

namespace suffuse::io {

bool looks_like_legacy_vtk(std::string_view text);

/// Arrays by section and name as read_vtk_arrays() has them: "Points", "PointData/radius".
/// @throws CaseError where an array cannot be read; `file` is named.
std::map<std::string, VtkColumn> read_legacy_vtk_arrays(const std::string& file, std::string_view text);

} // namespace suffuse::io
