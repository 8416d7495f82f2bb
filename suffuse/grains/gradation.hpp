#pragma once
// The grading of the grains that are there, by mass: what is left of the soil after an extraction. One point a grain
// size.

#include "suffuse/grains/grains.hpp"
#include "suffuse/grains/soil.hpp"

#include <vector>

namespace suffuse::grains {

/// Sizes in ascending order, and the mass share of the grains up to and with each of them.
struct Gradation {
    std::vector<double> diameter; ///< each different size once [m]
    std::vector<double> passing;  ///< ends at 1 [-]
};

/// The gradation of all grains, or of those of the fine or the coarse fraction.
Gradation measure_gradation(const Grains& grains);
Gradation measure_gradation_of(const Grains& grains, bool fine);

/// Mass share of the grains not larger than `diameter` [-].
double passing(const Gradation& gradation, double diameter);

/// D_x: smallest size such that the share `fraction` of the mass is not larger [m]; 0 without grains.
double size_at(const Gradation& gradation, double fraction);

/// The gradation as a curve from 0 to 1: a steep step at each size, level between sizes, so that criteria may read it.
/// Sizes less than a step's width apart share one. @throws Bug without grains.
Grading curve_of_steps(const Gradation& gradation);

/// D50 of all grains: the size that inertial numbers and lent inertia go by [m].
double median_diameter(const Grains& grains);

} // namespace suffuse::grains
