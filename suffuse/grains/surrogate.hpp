#pragma once
// A soil too wide to simulate, as two fractions that have its size ratio and its fines content, and its widths as far
// as those can be paid for. Which gradient moves fines depends on no length: seepage force and weight both act per
// volume, and slow flow has no scale. It depends on the ratio D50/d50 of the coarse part and the fines, on their
// content, on the density, and on how wide the two parts are: the smallest fines move first, and a wide skeleton is
// denser (docs/theory/surrogates.md: how well).

#include "suffuse/grains/soil.hpp"

#include <optional>

namespace suffuse::grains {

/// D50 of the coarse part / d50 of the finer part of a curve that is split at a size [m]; the curve may have open ends.
/// Nothing where one of the two sizes was not measured, or a part has no mass.
std::optional<double> size_ratio(const Grading& measured, double finer_than);

/// D90/D10 of the part of a curve between two shares of the mass; nothing where one of them was not measured.
std::optional<double> width_between(const Grading& curve, double from, double to);

/// Least size ratio of two fractions that size alone separates.
inline constexpr double least_size_ratio = 1.3;

/// Largest size of a fraction over its smallest: at least within a tenth of the mean to either side, at most what can
/// be paid for.
inline constexpr double least_width = 1.1 / 0.9, most_coarse_width = 2, most_fines_width = 4;

struct SurrogateSpec {
    double finer_than = 0; ///< where the curve is split [m]
    /// Of the fractions, unless those of the curve: its D50/d50, and widths with its D90/D10, within the bounds above.
    std::optional<double> size_ratio, coarse_width, fines_width;
};

/// The two fractions, each log-uniform; the coarse grains keep their median size. A width that was not measured is the
/// largest, and where the fractions would overlap both are narrower. `measured` and `surrogate` of the soil say what
/// they stand for.
/// @throws CaseError where the curve has no size ratio at this split, or the ratio is below `least_size_ratio`.
Soil surrogate_of(const Grading& measured, const SurrogateSpec& spec);

} // namespace suffuse::grains
