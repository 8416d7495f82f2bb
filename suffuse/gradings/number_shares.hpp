#pragma once
// Shares of the number of grains, as of images, turned into shares of their mass.

#include "suffuse/gradings/grading_curve.hpp"
#include "suffuse/gradings/grading_rows.hpp"

#include <vector>

namespace suffuse::gradings {

/// Grains of a class have its geometric mean size. Nothing may be finer than the finest size; what is coarser than the
/// coarsest is in a class as wide as the one before it. @return whether it could be done; if not, that is reported.
bool weigh_by_size(const SievedSoil& soil, std::vector<GradingPoint>& points, Problems& problems);

} // namespace suffuse::gradings
