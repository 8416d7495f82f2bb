#pragma once
// Packings as tables: a row a grain, columns x, y, z, r (or a diameter) and perhaps vx, vy, vz, wx, wy, wz, between
// commas, semicolons, blanks or tabs. Their names stand in a header or, of columns between blanks, in a comment above
// as Yade's `#format id_x_y_z_r`; without either the columns are x y z r. Yade's `##PERIODIC:: LX LY LZ` gives the
// cell.

#include "suffuse/io/packing_file.hpp"

#include <string_view>

namespace suffuse::io {

/// @throws CaseError with file and line.
ImportedPacking
parse_table(const std::string& file, std::string_view text, double density, std::optional<double> radius = {});

} // namespace suffuse::io
