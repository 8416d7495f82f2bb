#pragma once
// What the fines do in the skeleton: void ratios that count all, none or the active fines as solid [Thevanayagam 2000],
// the share of fines that is active, and which fractions meet in the contacts, all and strong ones. The active share is
// measured here, where laboratory work has to fit it. One density for all grains: shares by mass and by volume agree.

#include "suffuse/dem/world.hpp"
#include "suffuse/stats/contact_class.hpp"

namespace suffuse::stats {

struct FinesState {
    double fines_content = 0;            ///< FC, by mass [-]
    double void_ratio = 0;               ///< e [-]
    double intergranular_void_ratio = 0; ///< e_g = (e + FC)/(1 - FC): fines are voids; infinite for fines alone [-]
    double equivalent_void_ratio = 0;    ///< e_eq = (e + (1 - b) FC)/(1 - (1 - b) FC): inactive fines are voids [-]
    double active_fraction = 0;     ///< b: volume of fines with >= 2 contacts / volume of fines; 0 without fines [-]
    PerClass<double> contact_share; ///< of the number of contacts; zeros without contacts [-]
    PerClass<double> strong_contact_share; ///< of the contacts whose force exceeds the mean over all contacts [-]
};

FinesState measure_fines(const dem::World& world);

} // namespace suffuse::stats
