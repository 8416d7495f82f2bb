#pragma once
// The paper's findings on erosion, E1 to E7, judged by criteria that were fixed before the first run (docs: the
// report's findings table). "Cannot tell" is an answer of its own: a gradient that was not probed, a pass that took no
// grain.

#include "suffuse/erosion/result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

/// Nothing where a run cannot tell.
using Verdict = std::optional<bool>;

/// A claim of two parts: false as soon as one part is, true only when both are known to be.
inline Verdict both(Verdict first, Verdict second) {
    if (first == false || second == false) {
        return false;
    }
    return first && second ? Verdict(true) : std::nullopt;
}

struct Finding {
    std::string id;    ///< "E1" to "E7"
    std::string claim; ///< the criterion, in words
    std::string paper; ///< what the paper reports
    std::string ours;  ///< what this run found, with numbers
    Verdict met;
};

/// A change of porosity below this is within what the servo's tolerance on the stress allows: neither a rise nor a
/// fall.
inline constexpr double porosity_resolution = 1e-5;

/// E1 to E7 from the probes of a `detach` stage (any number, of any gradients) and the passes of an `erode` stage. The
/// probe of the first pass is one of the probes. Detached means: by the velocity rule, the paper's.
std::vector<Finding>
judge_erosion(const std::vector<erosion::ProbeResult>& probes, const erosion::ErosionResult& erosion);

/// One verdict for the same case run with several seeds: where the seeds disagree, the criterion cannot be told.
std::vector<Finding> combine_seeds(const std::vector<std::vector<Finding>>& by_seed);

/// Grains that the velocity rule finds detachable, and those that it does not.
struct Detached {
    std::int64_t yes = 0, no = 0;
};

Detached count_detached(const erosion::ProbeResult& probe);

} // namespace suffuse::study
