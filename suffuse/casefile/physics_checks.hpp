#pragma once
// Can this be a soil sample? Estimates before the first step: cell against largest grain, overlap at the pressure,
// gradient against the critical one, fines to erode. Estimates only: the run itself measures.

#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Reports what cannot work as an error and what is doubtful as a warning. `settings` has material, fluid and balance.
void check_physics(ReadContext& context, const Case& settings, const Study& study, const Variant& variant);

/// The same for the number of grains: only the narrowest cell of all variants is reported.
void check_sample_sizes(ReadContext& context, const Case& settings, const Study& study);

/// Width of a settled cubic cell / largest grain, for `particles` grains of `soil` [-]; 0 where it cannot be told.
double width_in_grains(const grains::Soil& soil, std::int64_t particles);

/// Mean overlap / mean radius that `pressure` [Pa] causes in an assembly of spheres of contact modulus `modulus` [Pa].
double overlap_at(double pressure, double modulus);

/// What a modulus should keep squeezed_overlap_at() to [-].
inline constexpr double good_squeezed = 0.05;

/// Largest overlap / smaller radius: of the finest grains caught between the coarsest, whose forces they then carry.
/// From runs of size ratios from 4 to 12, within a factor of two. @param size_ratio of the coarsest to the finest grain
double squeezed_overlap_at(double pressure, double modulus, double size_ratio);

} // namespace suffuse::casefile
