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

/// Whether what they do without fluid hides so many fines that the velocity rule cannot show what the fluid detaches.
bool noise_decides(const DetachSpec& spec, const ProbeResult& result);

/// Whether of the grains that the velocity rule takes too many are not accepted by the displacement rule, which looks
/// at what a grain does beyond its own twin: they move for another reason than the water.
bool takes_unaccepted(const ProbeResult& result);

/// Of its diameter, how far the water would move a fine grain during the probe were it free of contacts: one in 20 goes
/// as far or farther [-].
double free_travel(const ProbeResult& result);

/// Beyond this free travel fines hit others before they are judged, and slow down as if they were held: fewer count as
/// detachable the steeper the gradient is. Neighbors are a few thousandths of a diameter away. [-]
inline constexpr double far_travel = 1e-3;

/// Whether the fines move with the water: ten times as fast as their twin in the median, or faster.
inline bool has_clear_signal(const ProbeResult& result) {
    return result.signal_over_twin >= 10;
}

/// Whether an absolute speed, which knows no twin, decides by grains that the displacement rule does not accept.
bool threshold_takes_noise(const DetachSpec& spec, const ProbeResult& result);

/// The verdicts of the specified rule.
const std::vector<std::uint8_t>& verdicts(const DetachSpec& spec, const ProbeResult& result);

} // namespace suffuse::erosion
