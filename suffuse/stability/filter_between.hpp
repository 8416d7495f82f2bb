#pragma once
// Whether one soil is a filter for another: does the filter hold the base, and does it drain it? Its D15 beside d85,
// d95 and d15 of the base. [Terzaghi and Peck 1948] [NRCS 2017, chapter 26, after Sherard and Dunnigan 1985; its rule
// for 15 to 39 % of fines as in table 9.2 of Fell et al. 2005] [Foster and Fell 2001]

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/criterion.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::stability {

/// The base soil as the filter sees it: without what is coarser than 4.75 mm, which skips no filter and holds none.
struct BaseSoil {
    bool is_regraded = false;
    int category = 0;            ///< 1 to 4 by fines, 0 where they were not measured
    std::optional<double> fines; ///< finer than 0.075 mm [-]
    std::optional<double> d85;   ///< [m]
    std::optional<double> d95;   ///< [m]
    std::optional<double> d15;   ///< of the base as it is, not regraded [m]
};

/// @param measured may be open at its ends; sizes that were not measured are left out
BaseSoil characterize_base(const grains::Grading& measured);

/// The largest D15 of a filter by the fines of the base [m].
struct LargestFilter {
    double d15 = 0;
    std::string rule;
};

std::optional<LargestFilter> largest_filter(const BaseSoil& base);

/// Terzaghi's ratio, no erosion by the category of the base, continuing erosion, and permeability. Stable: it holds.
std::vector<Criterion> filter_criteria(const grains::Grading& base, const grains::Grading& filter);

/// "holds", "fails", "cannot say".
const char* filter_word(Verdict verdict);

} // namespace suffuse::stability
