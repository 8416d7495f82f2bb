#pragma once
// Where a soil falls into coarse grains and the fines that they do not hold.

#include "suffuse/grains/soil.hpp"

#include <optional>
#include <string>

namespace suffuse::stability {

struct UnstableSplit {
    double finer_than = 0; ///< [m]
    std::string reason;
};

/// Where the criteria find the soil least stable: at its gap, else where the shape curve is worst, else at the split
/// with the worst filter ratio; nothing where none of them finds it unstable with at most 40 % of fines: more leave no
/// skeleton. The curve may have open ends.
std::optional<UnstableSplit> find_unstable_split(const grains::Grading& measured);

/// "no split of this curve is unstable: it has no gap, H/F is at least 1.4 (Kenney and Lau 1986: 1), ...": why there is
/// no such split, and of which part of the curve.
std::string no_split_text(const grains::Grading& measured);

} // namespace suffuse::stability
