#pragma once
// Stress of single grains, and the share that the fines carry [Shire 2014; Skempton & Brogan 1994]. A grain's stress is
// that of the forces at its contact points; times the grains' volumes they add up to the stress of the cell exactly.
// The contact point divides the branch as the radii less half the overlap do.

#include "suffuse/dem/world.hpp"

#include <vector>

namespace suffuse::stats {

/// Volume times stress of each grain, compression positive [N m].
std::vector<Mat3> grain_stress_moments(const dem::World& world);

/// Stress of each grain, the mean over its volume, compression positive [Pa].
std::vector<Mat3> grain_stresses(const dem::World& world);

struct StressByFraction {
    Mat3 total;               ///< of the cell, compression positive [Pa]
    Mat3 coarse, fines;       ///< parts of it that each fraction carries; they add up to `total` [Pa]
    double fines_share = 0;   ///< of the mean stress; 0 without stress [-]
    double fines_content = 0; ///< by volume [-]
    double alpha_fines = 0;   ///< mean stress in the fines / mean stress, both per volume of cell: share / content [-]
    double alpha_coarse = 0;  ///< likewise; FC alpha_fines + (1 - FC) alpha_coarse = 1 [-]
};

StressByFraction measure_stress_by_fraction(const dem::World& world);

} // namespace suffuse::stats
