#pragma once
// Are there enough grains? Estimates of the sample that a soil and a number of grains will make: its cell against the
// largest grain, its skeleton against what erosion can judge, its fines.

#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

inline constexpr double settled_porosity = 0.4; ///< of sands at some 100 kPa

/// Reports what cannot work as an error and what is doubtful as a warning; of the cells only the narrowest of all
/// variants.
void check_sample_sizes(ReadContext& context, const Study& study);

/// Width of a settled cubic cell / largest grain, for `particles` grains of `soil` [-]; 0 where it is unknown.
double width_in_grains(const grains::Soil& soil, std::int64_t particles);

/// The curve of all grains; nothing where the soil lacks a part of it.
std::optional<grains::Grading> whole_grading(const grains::Soil& soil);

/// Diameter [m].
double largest_grain(const grains::Grading& grading);

} // namespace suffuse::casefile
