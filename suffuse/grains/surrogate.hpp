#pragma once
// A soil too wide to simulate, as two fractions of nearly equal grains that have its size ratio and its fines content.
// Which gradient moves fines depends on no length: seepage force and weight both act per volume, and slow flow has no
// scale. It depends on the ratio D50/d50 of the coarse part and the fines, on their content, and on the density
// (docs/theory/surrogates.md: how well).

#include "suffuse/grains/soil.hpp"

#include <optional>

namespace suffuse::grains {

/// D50 of the coarse part / d50 of the finer part of a curve that is split at a size [m]; the curve may have open ends.
/// Nothing where one of the two sizes was not measured, or a part has no mass.
std::optional<double> size_ratio(const Grading& measured, double finer_than);

/// Least size ratio of two fractions, each `surrogate_width` wide, that size alone separates.
inline constexpr double least_size_ratio = 1.3;

/// Largest size of a fraction over its smallest: within a tenth of the mean to either side.
inline constexpr double surrogate_width = 1.1 / 0.9;

/// The two fractions; the coarse grains keep their size. `measured` and `surrogate` of the soil say what they stand
/// for.
/// @param modeled size ratio of the fractions; that of the curve unless given
/// @throws CaseError where the curve has no size ratio at this split, or the ratio is below `least_size_ratio`.
Soil surrogate_of(const Grading& measured, double finer_than, std::optional<double> modeled = {});

} // namespace suffuse::grains
