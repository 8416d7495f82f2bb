#pragma once
// The cell of an imported packing: the case's, else the file's own.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/import_spec.hpp"
#include "suffuse/io/packing_file.hpp"

namespace suffuse::run {

/// Columns are the cell vectors [m]. @throws CaseError where neither the case nor the file gives one.
inline Mat3 imported_cell(const casefile::ImportSpec& spec, const io::ImportedPacking& packing) {
    if (!(spec.cell == Mat3{})) {
        return spec.cell;
    }
    if (!packing.cell) {
        throw CaseError(
            spec.place + ": " + spec.path + " carries no cell; give `cell`, three lengths or a 3 x 3 matrix whose " +
            "columns are the cell vectors"
        );
    }
    return packing.cell->h;
}

} // namespace suffuse::run
