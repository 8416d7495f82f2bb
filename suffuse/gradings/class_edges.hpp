#pragma once
// Shares of classes between edges, of which there is one more: sizes without a share show on which side of its size
// each share lies, and which size all grains pass.

#include "suffuse/gradings/grading_curve.hpp"
#include "suffuse/gradings/grading_rows.hpp"

#include <vector>

namespace suffuse::gradings {

std::vector<SieveRow*> coarsest_first(SievedSoil& soil);

/// Without a share at the finest edge each share lies below its own size: it then goes to the next finer size. Without
/// one at the coarsest edge all grains pass that. Other sizes without a value are skipped; all is reported.
void settle_edges(SievedSoil& soil, Problems& problems);

/// Adds the coarser bound of the coarsest class, which all grains pass.
void close_curve(SievedSoil& soil, std::vector<GradingPoint>& points);

/// Turns shares of the number of grains, as of images, into shares of their mass. Grains of a class have its geometric
/// mean size. Nothing may be finer than the finest size; what is coarser than the coarsest is in a class as wide as the
/// one before it. @return whether it could be done; if not, that is reported.
bool weigh_by_size(const SievedSoil& soil, std::vector<GradingPoint>& points, Problems& problems);

} // namespace suffuse::gradings
