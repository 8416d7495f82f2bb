#pragma once
// Criteria on the shape curve: is there, at every size d of the finer part, enough soil between d and 4d to hold it?
// [Kenney and Lau 1985, 1986] [Li and Fannin 2008], in the reading of [RMC 2023].

#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/curve.hpp"

#include <optional>

namespace suffuse::stability {

/// How much of the curve counts: F up to 20 % where the primary fabric is widely graded (D60/D10 > 3), up to 30 % where
/// it is not.
double finer_limit(double uniformity_of_fabric);

/// Where H/F is least.
struct LeastRatio {
    double value = 0; ///< (H/F)min [-]
    ShapePoint at;
};

/// The least H/F with 0 < F <= `limit`.
LeastRatio least_shape_ratio(const grains::Grading& grading, double limit);

/// What the numbers are.
inline constexpr const char* shape_ratio_measure = "(H/F)min";
inline constexpr const char* secant_ratio_measure = "min H/min(F, 15 %)";

/// The least number of either measure of the part of a curve that was measured: F up to `limit`, and 4d on the curve.
/// Nothing where none of it was measured, or for another measure.
std::optional<LeastRatio>
least_measured_ratio(const grains::Grading& measured, double limit, const std::string& measure);

/// "; a trace: only this 1.1 % of the mass could leave", where less is finer than a part of a soil has
/// (filter_ratio.hpp).
std::string trace_text(const LeastRatio& least);

/// "at d = 0.25 mm, F = 20 % (F up to 20 %)".
std::string place_of(const LeastRatio& least, double limit);

/// Unstable where H/F < 1.3 for some F up to the limit.
Criterion kenney_lau_1985(const grains::Grading& grading, double limit);

/// Unstable where H/F < 1.
Criterion kenney_lau_1986(const grains::Grading& grading, double limit);

/// Unstable where H is less than both F and 15 %. Its number is the least H/min(F, 15 %), to be at least 1.
Criterion li_fannin(const grains::Grading& grading, double limit);

} // namespace suffuse::stability
