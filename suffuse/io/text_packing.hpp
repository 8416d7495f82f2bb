#pragma once
// Packings as tables: a row a grain, columns x, y, z, r (or a diameter) and perhaps vx, vy, vz, wx, wy, wz, between
// commas, semicolons, blanks or tabs. Their names are in a heading (packing_columns.hpp) or, of columns between blanks,
// in a comment above as Yade's `#format id_x_y_z_r`; without either headless_packing.hpp decides. Yade's `##PERIODIC::
// LX LY LZ` gives the cell.

#include "suffuse/io/packing_file.hpp"
#include "suffuse/io/packing_source.hpp"

namespace suffuse::io {

/// @throws CaseError with file and line.
ImportedPacking parse_table(const PackingSource& source);

} // namespace suffuse::io
