#pragma once
// The paper's findings on erosion, E1 to E7, judged by criteria that were fixed before the first run (docs: the
// report's findings table). "Cannot tell" is an answer of its own: a gradient that was not probed, a pass that took no
// grain.

#include "suffuse/erosion/result.hpp"
#include "suffuse/study/finding.hpp"

#include <vector>

namespace suffuse::study {

/// A change of porosity below this is within what the servo's tolerance on the stress allows: neither a rise nor a
/// fall.
inline constexpr double porosity_resolution = 1e-5;

/// E1 to E7 from the probes of a `detach` stage (any number, of any gradients) and the passes of an `erode` stage. The
/// probe of the first pass is one of the probes. Detached means: by the velocity rule, the paper's.
std::vector<Finding>
judge_erosion(const std::vector<erosion::ProbeResult>& probes, const erosion::ErosionResult& erosion);

/// Grains that the velocity rule finds detachable, and those that it does not.
struct Detached {
    std::int64_t yes = 0, no = 0;
};

Detached count_detached(const erosion::ProbeResult& probe);

} // namespace suffuse::study
