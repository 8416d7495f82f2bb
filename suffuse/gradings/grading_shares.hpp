#pragma once
// From what sieves retain to what passes them: shares or masses, each sieve's own or cumulative.

#include "suffuse/gradings/grading_curve.hpp"
#include "suffuse/gradings/grading_rows.hpp"

#include <optional>
#include <vector>

namespace suffuse::gradings {

/// The points of a soil's curve in the order of its rows; empty where its numbers do not say which they are, or of
/// which mass they are a share, which is reported.
std::optional<std::vector<GradingPoint>> find_passing(SievedSoil soil, Problems& problems);

} // namespace suffuse::gradings
