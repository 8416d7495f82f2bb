#pragma once
// Extended XYZ, as OVITO and ASE write it: `Lattice="..."` with the cell's vectors, `Properties=...` with pos:R:3,
// radius:R:1 or diameter:R:1 and perhaps velo:R:3, angular_velocity:R:3, fine:I:1. The first frame.

#include "suffuse/io/packing_file.hpp"
#include "suffuse/io/packing_source.hpp"

#include <string_view>

namespace suffuse::io {

[[nodiscard]] bool looks_like_extended_xyz(std::string_view text);

/// @throws CaseError with file and line.
ImportedPacking parse_extended_xyz(const PackingSource& source);

} // namespace suffuse::io
