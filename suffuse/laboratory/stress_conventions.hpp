#pragma once
// Which stresses are effective, and whether q is axial minus radial stress and p the mean of three stresses. Stresses
// that belong together decide: p = radial stress + q/3, and the pore pressure is what total stresses have more.

#include "suffuse/laboratory/record_review.hpp"

namespace suffuse::laboratory {

/// Compression is positive: a stress that is negative in the mean is refused.
void check_stresses_are_compressive(const RecordReview& review);

/// Columns whose headings are s and t become p and q. @throws CaseError where s has neither q nor t
void settle_halves(const RecordReview& review);

/// @throws CaseError where two readings are possible, or columns contradict one another.
void settle_triaxial_stresses(const RecordReview& review);
void settle_oedometer_stress(const RecordReview& review);

} // namespace suffuse::laboratory
