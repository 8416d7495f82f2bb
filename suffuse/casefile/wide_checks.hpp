#pragma once
// What a wide grading requires of a compaction: a stiffness with which fine grains caught between coarse ones do not
// vanish in them, and a protocol that gets there. Estimates from the grading; the run itself measures.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/case.hpp"

#include <optional>

namespace suffuse::casefile {

/// What a modulus should keep squeezed_overlap_at() to [-].
inline constexpr double good_squeezed = 0.05;

/// Largest overlap seen in samples of `wide` over the estimate [-].
inline constexpr double strongest_of_wide = 1.5;

/// Coarsest over finest grain, below which neither was looked at [-].
inline constexpr double wide_grading = 4;

/// Largest overlap / smaller radius: of the finest grains caught between the coarsest, whose forces they then carry.
/// From runs of size ratios from 4 to 30, within a factor of two. @param size_ratio of the coarsest to the finest grain
double squeezed_overlap_at(double pressure, const grains::Material& material, double size_ratio);

/// The modulus with which grains overlap by so many times less [Pa], rounded up to two digits.
double stiffer_modulus(const grains::Material& material, double times);

/// Warns where the finest grains of a wide grading overlap too far, however small the mean overlap is.
/// @param pressure at the place [Pa]; @param protocol of the compaction, of which `wide` promises good_squeezed
void check_squeezed(
    Problems& problems, const Place& place, double pressure, const Variant& variant,
    std::optional<packing::Protocol> protocol
);

/// Warns of a protocol that the grading is too wide for, or not wide enough.
void check_protocol(
    Problems& problems, const Place& place, std::string_view stage, packing::Protocol protocol, const Variant& variant
);

} // namespace suffuse::casefile
