#pragma once
// The packing that a benchmark works on: made on the spot or read from a file, and repeated along the axes for larger
// samples.

#include "suffuse/base/vec3.hpp"
#include "suffuse/dem/world.hpp"

#include <filesystem>

namespace suffuse::plan {

struct BenchPacking {
    std::filesystem::path file; ///< empty: 10,000 grains of the example's sand are made, always the same
    Mat3 cell{};                ///< columns are the cell vectors [m]; zeros: the file's own
    int replicate = 1;          ///< copies along each axis: n^3 times the grains
};

/// The packing at rest, with the contact law of the example (the defaults of Material) and without contact memory.
/// @throws IoError, CaseError as io::read_packing; CaseError where grains overlap by more than a tenth of a radius.
dem::World load_bench_packing(const BenchPacking& packing);

} // namespace suffuse::plan
