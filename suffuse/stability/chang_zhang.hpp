#pragma once
// Criterion by fines content, for soils with and without a gap, from 131 tested soils [Chang and Zhang 2013].

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/criterion.hpp"

namespace suffuse::stability {

/// P is the mass finer than 0.063 mm. Without a gap: stable above P = 20 %; where (H/F)min > 1 below 5 %; on the line
/// between these two, 4/3 - P/15 (P in %), else. With a gap: stable above P = 35 %; where the gap ratio Gr, largest
/// over smallest missing size, is below 3 for P under 10 %; Gr < 0.3 P between, a rule that we did not read in a
/// source. (H/F)min is taken up to F = `limit`, as Kenney and Lau do.
Criterion chang_zhang(const grains::Grading& grading, double limit);

} // namespace suffuse::stability
