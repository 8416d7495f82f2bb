#pragma once
// The paper's findings on fines content and microstructure, M1 to M9, judged by criteria that were fixed before the
// first run (docs: formats). Every seed is judged by itself: they decide together, and where they disagree, or where
// the fines contents that were run cannot decide, the answer is "cannot tell".

#include "suffuse/study/findings.hpp"
#include "suffuse/study/fines_thresholds.hpp"

#include <cstdint>

namespace suffuse::study {

inline constexpr double isotropic_below = 0.1; ///< q/p of a sample under no deviator but that of its preparation

/// One sample that lost fines at once.
struct Removal {
    double fines_content = 0; ///< before [-]
    std::uint64_t seed = 0;
    double stress_ratio = 0;  ///< q/p before [-]
    double removed_share = 0; ///< of the mass [-]
    double strain = 0;        ///< the largest of an axis, in size [-]
    double stress_loss = 0;   ///< of the mean stress at constant volume [-]
    bool failed = false;      ///< the skeleton did not carry its stresses any more: the strain is a lower bound
    std::optional<double> peak_before, peak_after; ///< peak deviator stress with and without the fines [Pa]
};

/// M1 to M8 from the loose and the dense stage of a study over the fines content (`dense` may be null), M9 from
/// removals. Without loose curves nothing is judged but M9. `size_ratio`, D50 over d50, stands in the reasons.
std::vector<Finding> judge_fines(
    const StageCurve* loose, const StageCurve* dense, const std::vector<Removal>& removals,
    std::optional<double> size_ratio = std::nullopt
);

/// M9 alone.
Finding judge_removals(const std::vector<Removal>& removals);

} // namespace suffuse::study
