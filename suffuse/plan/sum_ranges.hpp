#pragma once
// The range of a sum: parts that err by themselves seldom err all to one side.

#include "suffuse/base/range.hpp"

#include <vector>

namespace suffuse::plan {

/// The middle is the sum of the middles. Of each part's error a factor of 1.3 counts as common to all, the machine's;
/// the rest as the part's own, of which squares add up. One part is as wide as it was.
Range sum_ranges(const std::vector<Range>& parts);

} // namespace suffuse::plan
