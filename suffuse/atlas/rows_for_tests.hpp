#pragma once
// Small tables for tests, whose numbers follow from a formula.

#include "suffuse/atlas/row.hpp"

namespace suffuse::atlas::test {

/// A loose sample under upward flow with i_c = 1.
inline Row row_at(double ratio, double fines, double moves_1, int seed = 1) {
    Row row;
    row.size_ratio = ratio, row.fines_content = fines, row.seed = seed;
    row.porosity = 1 - 1 / 1.65, row.alpha = fines, row.heave = 1;
    row.moves_1.gradient = moves_1, row.moves_10.gradient = 2 * moves_1;
    return row;
}

} // namespace suffuse::atlas::test
