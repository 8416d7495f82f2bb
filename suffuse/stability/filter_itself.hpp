#pragma once
// Whether a filter stays what it was when it was placed: few fines that bind it, sizes that do not part while it is
// dumped [NRCS 2017], and a coarse part that holds its own fine one [Kenney and Lau 1986] [Kezdi 1979].

#include "suffuse/stability/assess.hpp"
#include "suffuse/stability/measured_part.hpp"

#include <optional>
#include <vector>

namespace suffuse::stability {

/// Fines, segregation, and two criteria of internal stability. @param own of the same filter
std::vector<Criterion> judge_filter_itself(const grains::Grading& filter, const Assessment& own);

/// What is left of a filter whose coarse part does not hold its fine one.
struct WashedOut {
    double finer_than = 0; ///< grains that water can take [m]
    Bounds d15;            ///< of the others [m]
};

/// Nothing for a filter that is stable, or has no fine fraction.
std::optional<WashedOut> washed_out_d15(const grains::Grading& filter, const Assessment& own);

} // namespace suffuse::stability
