#pragma once
// Spheres of Kratos Multiphysics, .mdpa: nodes, and RADIUS among their data. Comments begin with //.
// [Kratos documentation, "Input data", .mdpa]

#include "suffuse/io/packing_file.hpp"
#include "suffuse/io/packing_source.hpp"

namespace suffuse::io {

[[nodiscard]] bool looks_like_kratos(std::string_view text);

/// @throws CaseError with file and line.
ImportedPacking parse_kratos(const PackingSource& source);

} // namespace suffuse::io
