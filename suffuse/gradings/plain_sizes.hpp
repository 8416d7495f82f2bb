#pragma once
// What plain numbers in a column of sizes mean where its heading does not say.

#include "suffuse/gradings/grading_columns.hpp"

namespace suffuse::gradings {

struct PlainSizes {
    SizeScale scale = SizeScale::Unknown;
    bool has_plain = false; ///< sizes without a unit
    bool mix_units = false; ///< some sizes have a unit other than mm and others none, under a heading that does not say
};

/// Sieve numbers where the sizes rise and fall as they should only that way.
PlainSizes judge_plain_sizes(const Sheet& sheet, const GradingColumns& columns);

} // namespace suffuse::gradings
