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
/// with the worst filter ratio; nothing where none of them finds it unstable. The curve may have open ends.
std::optional<UnstableSplit> find_unstable_split(const grains::Grading& measured);

/// "it has no gap, H/F is at least 1.4 (Kenney and Lau 1986: 1), D15c/d85f at most 2.1 (Kezdi 1979: 4)": why a curve
/// has no such split.
std::string stable_everywhere_text(const grains::Grading& measured);

} // namespace suffuse::stability
