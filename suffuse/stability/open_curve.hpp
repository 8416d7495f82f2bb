#pragma once
// A grading whose ends were not measured: the finest sieve still passes something, or the coarsest not all. What any
// criterion says is taken only where it is the same however the missing ends may look: sharply cut, tapering off, or
// far away beyond a gap, all of it or as much as Kenney and Lau judge.

#include "suffuse/stability/assess.hpp"

#include <vector>

namespace suffuse::stability {

/// Whether a curve begins above 0 % or ends below 100 %.
bool is_open(const grains::Grading& measured);

/// "the 4 % below 0.063 mm and the 2 % above 31.5 mm".
std::string missing_text(const grains::Grading& measured);

/// The curve with its ends as they might be, the sharp ones first; a closed curve alone.
std::vector<grains::Grading> complete_ends(const grains::Grading& measured);

/// As assess(), for a curve that may be open. Criteria that depend on what was not measured cannot say; those of the
/// shape curve still give the number of what was measured. `grading` is the sharply completed curve.
/// @throws as assess().
Assessment assess_measured(const grains::Grading& measured, const AssessSpec& spec = {});

} // namespace suffuse::stability
