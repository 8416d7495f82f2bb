#pragma once
// Units and signs of strains: contraction and compression are positive in the end. The void ratio e decides, as a
// contraction is (e0 - e) / (1 + e0); else the heading, the work of the stress, or the caller.

#include "suffuse/laboratory/record_review.hpp"

#include <optional>

namespace suffuse::laboratory {

/// Of a triaxial test. @throws CaseError where nothing decides, or columns contradict one another.
void settle_volumetric_strain(const RecordReview& review, std::optional<bool> contraction_is_positive);
void settle_triaxial_axial_strain(const RecordReview& review);

/// Likewise, of an oedometer test.
void settle_oedometer_strain(const RecordReview& review);

} // namespace suffuse::laboratory
