#pragma once
// Fines of a weighed copy fall into place under their weight alone, before any water pulls at them.

#include "suffuse/base/pulse.hpp"
#include "suffuse/erosion/weighed_copy.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::erosion {

struct Rest {
    bool ended = false;               ///< before the longest time that it was given
    double took = 0;                  ///< in units of WeightScale::time [-]
    std::vector<std::uint8_t> moving; ///< in the last of it: 1 for each of the copy's fines that was still on its way
};

/// Bursts until so few still move that all count as resting (mobility_bounds.hpp).
Rest rest_under_weight(WeighedCopy& copy, const Pulse& pulse);

} // namespace suffuse::erosion
