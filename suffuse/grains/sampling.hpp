#pragma once
// Grains drawn from a grading curve. Each grain stands for an equal share of the number of grains and has the mean
// volume of its share, so that the sample meets the curve by mass exactly between grains and misses it only within one;
// a curve by number would leave the few coarse grains, which carry much of the mass, to chance. Nothing here is random.

#include "suffuse/base/pulse.hpp"
#include "suffuse/grains/soil.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace suffuse::grains {

struct SampledGrains {
    std::vector<double> radius;     ///< largest first [m]
    std::vector<std::uint8_t> fine; ///< 1: belongs to the fine fraction
    double fines_content = 0;       ///< of the sample, by mass [-]
    double largest_difference = 0;  ///< of percent passing between sample and grading, as a fraction [-]
};

/// `particles` grains of `soil`. Throws CaseError where the soil is not well defined, where Kenney and Lau's split does
/// not exist, or where so few grains cannot follow the curve within the soil's tolerance (it says how many would). The
/// pulse beats with the grains drawn ("draw"): ten million take seconds.
SampledGrains sample_soil(const Soil& soil, int particles, const Pulse& pulse = {});

/// Cell width over the largest grain below which results depend on it [-].
inline constexpr double narrow_cell = 10;

/// The size below which grains of `soil` are fine [m]; nothing for a soil without a fine fraction. Of two curves it
/// lies between them. @throws CaseError where they overlap, or where Kenney and Lau's split does not exist.
std::optional<double> fines_limit(const Soil& soil);

/// @throws CaseError where one curve is split by a size that leaves no fines or no skeleton, or by none that exists.
void expect_both_parts(const Soil& soil);

/// The grading that `soil` specifies: its curve, or that of the mixture.
Grading specified_grading(const Soil& soil);

/// Diameters [m] of `count` grains that follow `grading`, largest first.
std::vector<double> sample_diameters(const Grading& grading, std::size_t count, const Pulse& pulse = {});

/// Mass fraction of a sample finer than each of `diameter` [m], one density for all grains; `radius` in any order [m].
std::vector<double> sample_curve(std::span<const double> radius, std::span<const double> diameter);

/// Largest difference of percent passing between a sample and a curve, over all sizes, as a fraction [-].
double largest_difference(std::span<const double> radius, const Grading& grading);

/// Number of grains in one m3 of solid that follows `grading` [1/m3].
double grains_per_volume(const Grading& grading);

/// Whether `count` grains follow `grading` within `tolerance`, judged from the coarsest ones: they carry most mass
/// each.
bool can_follow(const Grading& grading, double count, double tolerance);

/// Estimate of the least number of grains that follow `grading` within `tolerance`.
double grains_needed(const Grading& grading, double tolerance);

} // namespace suffuse::grains
