#pragma once
// Whether one soil is a filter for another: does it hold the base, drain it, and stay whole itself? [Terzaghi and Peck
// 1948] [NRCS 2017, chapter 26, after Sherard and Dunnigan 1985; its rule for 15 to 39 % of fines as in table 9.2 of
// Fell et al. 2005] [Foster and Fell 2001]

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/assess.hpp"
#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/measured_part.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::stability {

/// The base soil as the filter sees it: without the grains above a gap, which the finer ones pass between, and without
/// what is coarser than 4.75 mm, which skips no filter and holds none.
struct BaseSoil {
    std::optional<double> regraded_on; ///< the size above which grains are left out [m]; nothing: the curve as it is
    bool has_gap = false;              ///< that size is the fine end of a gap
    Bounds fines;                      ///< finer than 0.075 mm [-]
    Bounds d85;                        ///< [m]
    std::optional<double> width;       ///< d85/d15 [-]
    Bounds d95;                        ///< [m]
    Bounds d15;                        ///< of the base as it is, not regraded [m]
};

/// @param measured may be open at its ends; of sizes that were not measured it gives bounds
BaseSoil characterize_base(const grains::Grading& measured);

/// The largest D15 of a filter by the fines of the base.
struct LargestFilter {
    Bounds d15;                ///< [m]
    std::vector<int> category; ///< those that the base may have, 1 to 4
    std::string rule;          ///< " (4 d85)"; empty where it is a number, or where categories are two or more
};

LargestFilter largest_filter(const BaseSoil& base);

/// A filter of a base.
struct FilterCheck {
    Assessment own;                  ///< the filter's internal stability
    std::vector<Criterion> criteria; ///< Verdict::Stable: it holds
    Verdict verdict = Verdict::CannotSay;
    std::string outcome;               ///< "fails by 2 of 7 rules"
    std::vector<std::string> deciding; ///< the names of these rules; empty where it holds
};

/// Retention by Terzaghi's ratio, no erosion by the category of the base and continuing erosion; permeability; the
/// filter's own fines, segregation and stability; and, where it is not stable, retention once its fines are washed out.
/// @throws CaseError for a filter's curve that is none.
FilterCheck check_filter(const grains::Grading& base, const grains::Grading& filter);

/// "fails by 2 of 7 rules: Terzaghi and Peck, No erosion (NRCS 2017)".
std::string filter_summary(const FilterCheck& check);

/// "holds", "fails", "cannot say".
const char* filter_word(Verdict verdict);

} // namespace suffuse::stability
