#pragma once
// The few numbers of an erosion that are shown large beside the answer.

#include "suffuse/erosion/result.hpp"
#include "suffuse/report/page.hpp"

#include <vector>

namespace suffuse::report {

/// Eroded mass, change of permeability, largest loss of mean stress at constant volume, findings met: those that the
/// run can tell.
std::vector<Headline> erosion_headlines(const erosion::ErosionResult& erosion, const std::vector<Finding>& findings);

} // namespace suffuse::report
