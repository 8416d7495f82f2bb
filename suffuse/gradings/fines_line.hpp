#pragma once
// A line `Fines` next to a line `Pan` in a column of masses: what was washed out of the sample, the pan's mass once
// more, or the share of fines in percent. The sheet's own total, or its dry mass, decides; else the numbers do.

#include "suffuse/gradings/grading_rows.hpp"

namespace suffuse::gradings {

/// Adds washed fines to the pan. @return whether the line has one meaning, which is reported otherwise
bool settle_fines(SievedSoil& soil, Problems& problems);

} // namespace suffuse::gradings
