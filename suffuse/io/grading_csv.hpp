#pragma once
// A sieve analysis as laboratories write it, read without guessing: columns between commas, semicolons or tabs, decimal
// commas where commas separate nothing, units in the header (`d [um]`, `Sieve (mm)`, `% passing`) or at every number,
// percent passing, or percents or masses retained on each sieve or on it and all coarser ones. What could mean two
// things is refused.

#include "suffuse/base/diagnostics.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace suffuse::io {

/// One point of a curve and where it was written.
struct GradingPoint {
    double diameter = 0; ///< [m]
    double passing = 0;  ///< [-]
    Place diameter_place, passing_place;
};

/// The points in the order of the file; empty where something is wrong, all of which is reported.
std::optional<std::vector<GradingPoint>>
read_grading_points(const std::shared_ptr<const Source>& source, Problems& problems);

} // namespace suffuse::io
