#pragma once
// Can these stages be? Estimates before the first step: overlap at the pressure, gradient against the critical one,
// fines to erode, a stress to start from. Estimates only: the run itself measures.

#include "suffuse/casefile/reader.hpp"

namespace suffuse::casefile {

/// Reports what cannot work as an error and what is doubtful as a warning. `settings` has material, fluid and balance.
void check_physics(ReadContext& context, const Case& settings, const Study& study, const Variant& variant);

/// What a modulus should keep squeezed_overlap_at() to [-].
inline constexpr double good_squeezed = 0.05;

/// Largest overlap / smaller radius: of the finest grains caught between the coarsest, whose forces they then carry.
/// From runs of size ratios from 4 to 12, within a factor of two. @param size_ratio of the coarsest to the finest grain
double squeezed_overlap_at(double pressure, const grains::Material& material, double size_ratio);

} // namespace suffuse::casefile
