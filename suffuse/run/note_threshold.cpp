#include "suffuse/run/note_threshold.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/erosion/detachment.hpp"

#include <fmt/format.h>

namespace suffuse::run {

void note_threshold(
    StageWork& work, const std::string& when, const erosion::DetachSpec& rule, const erosion::ProbeResult& probe
) {
    if (!erosion::threshold_takes_noise(rule, probe)) {
        return;
    }
    const auto [refused, accepted] = probe.agreement[1];
    work.flaws.push_back(fmt::format(
        "{}, {}: {} fines are faster than {} m/s, and {} of them moved beyond their twin without water; the fines are "
        "{} times as fast as the twin's in the median: {}",
        work.place(), when, grouped(refused + accepted), short_number(rule.over_speed.value_or(0)), grouped(accepted),
        short_number(probe.signal_over_twin),
        erosion::has_clear_signal(probe)
            ? "their contacts deform elastically; raise `over`"
            : "the residual unbalanced forces decide, not the water; lower `probe_unbalanced_force`"
    ));
}

} // namespace suffuse::run
