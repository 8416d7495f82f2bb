#pragma once
// Criterion by fines content, for soils with and without a gap, from 131 tested soils [Chang and Zhang 2013].

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/criterion.hpp"

namespace suffuse::stability {

/// P is the mass finer than 0.063 mm. Without a gap: stable where (H/F)min > 1 below P = 5 %, and from 20 % on; with a
/// gap where its ratio Gr, largest over smallest missing size, is below 3 for P under 10 %, and above 35 %. Between, P
/// in %, (H/F)min > 4/3 - P/15, and Gr < 0.3 P: rules that we did not read in a source. (H/F)min is taken up to F =
/// `limit`, as Kenney and Lau do.
Criterion chang_zhang(const grains::Grading& grading, double limit);

} // namespace suffuse::stability
