#pragma once
// XYZ without `Properties`: the number of grains, a line for people, and a row a grain: its kind, x, y, z, or x, y, z
// alone. A second line of three lengths is the box, as exaDEM has it. Such a file has no radii. The first frame.
// [OVITO user manual, basic XYZ format; exaDEM, reader of .xyz]

#include "suffuse/io/packing_file.hpp"
#include "suffuse/io/packing_source.hpp"

namespace suffuse::io {

[[nodiscard]] bool looks_like_plain_xyz(std::string_view text);

/// @throws CaseError with file and line.
ImportedPacking parse_plain_xyz(const PackingSource& source);

} // namespace suffuse::io
