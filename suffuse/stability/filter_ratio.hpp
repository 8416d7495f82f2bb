#pragma once
// Criteria that ask whether the coarse part of a soil is a filter for its fine part: D15 of the one over d85 of the
// other, Terzaghi's filter ratio, after a split of the curve [Kezdi 1979] [Sherard 1979].

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/fine_fraction.hpp"

#include <optional>

namespace suffuse::stability {

struct FilterRatio {
    double value = 0;            ///< D15c/d85f [-]
    double coarse = 0, fine = 0; ///< D15c, d85f [m]
    double split = 0;            ///< mass fraction below the split [-]
};

/// At a split between two sizes [m].
FilterRatio filter_ratio(const grains::Grading& grading, double split);

/// The least share of the mass that either part of a split has: a trace of coarse or fine grains is no part of a soil.
/// Ours, as of a gap.
inline constexpr double least_part = 0.05;

/// The largest over all splits that leave either part `least_part` of the mass. From d85f to D15c lie always 15 % of
/// the mass: so this exceeds 4 exactly where the curve is flatter than 15 % of the mass per factor 4 of size somewhere
/// among them, the form in which [Li and Fannin 2008] give Kezdi's rule.
/// @param most_fines of the mass, finer than a split
FilterRatio worst_filter_ratio(const grains::Grading& grading, double most_fines = 1 - least_part);

/// Stable where D15c/d85f <= 4 for every split.
Criterion kezdi(const grains::Grading& grading);

/// Stable where D15c/d85f <= 5 at the split of the fine fraction, or for every split where there is none.
Criterion sherard(const grains::Grading& grading, const std::optional<FineFraction>& fines);

} // namespace suffuse::stability
