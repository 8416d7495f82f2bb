#pragma once
// Why a finding on fines content is not met: how the skeleton was kept, and at what size ratio, decides most of it.

#include "suffuse/study/finding.hpp"
#include "suffuse/study/fines_thresholds.hpp"

#include <optional>

namespace suffuse::study {

/// Fills in `why` where the finding is not plainly met and has none yet. `loose` may be null.
void give_reason(const StageCurve* loose, std::optional<double> size_ratio, Finding& finding);

} // namespace suffuse::study
