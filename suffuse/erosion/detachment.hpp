#pragma once
// Which of the watched fines are detachable. Two rules read the same probe: the paper's, on the growth of the speed,
// and the successor that it announces, on the displacement along the drag.

#include "suffuse/erosion/result.hpp"
#include "suffuse/erosion/spec.hpp"

namespace suffuse::erosion {

/// Fills in the verdict of both rules for every grain, the twin's noise level, which judges none, how many fines what
/// they do without fluid hides, and the two-way table of the rules' agreement. A grain on which no fluid force acts is
/// detachable by neither: at i = 0 both return no grain.
void judge_detachment(const DetachSpec& spec, ProbeResult& result);

/// Whether what they do without fluid hides so many fines that the velocity rule cannot tell what the fluid detaches.
bool noise_decides(const DetachSpec& spec, const ProbeResult& result);

/// The verdicts of the rule asked for.
const std::vector<std::uint8_t>& verdicts(const DetachSpec& spec, const ProbeResult& result);

} // namespace suffuse::erosion
