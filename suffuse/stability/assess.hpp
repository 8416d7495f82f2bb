#pragma once
// Internal stability of a soil by all criteria side by side, from its grading alone: no simulation, a part of a second.

#include "suffuse/grains/soil.hpp"
#include "suffuse/stability/constriction_model.hpp"
#include "suffuse/stability/criterion.hpp"
#include "suffuse/stability/critical_gradient.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/fine_fraction.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::stability {

/// What D60/D10 belongs to, when Kenney and Lau ask whether the primary fabric is widely graded.
enum class PrimaryFabric {
    Soil,  ///< the whole curve, the practice of [RMC 2023]
    Coarse ///< what is coarser than the fine fraction
};

struct AssessSpec {
    std::optional<double> finer_than = {};       ///< fine fraction [m]; found on the curve where not given
    std::optional<double> relative_density = {}; ///< 0 to 1 [-]
    PrimaryFabric fabric = PrimaryFabric::Soil;
    std::optional<Seepage> seepage = {};
};

struct Assessment {
    grains::Grading grading;
    std::optional<Gap> gap;
    std::optional<FineFraction> fines;
    double finer_limit = 0;           ///< up to which F Kenney and Lau look [-]
    std::vector<Criterion> criteria;  ///< of the grading
    std::vector<Criterion> gradients; ///< of upward seepage; empty where there is none
    FinesAgainstConstrictions constrictions;
    bool has_constrictions = true; ///< false: they depend on what was not measured

    /// Mass below the finest and above the coarsest size that was measured [-]: open_curve.hpp.
    double missing_fine = 0, missing_coarse = 0;
};

inline constexpr std::size_t kenney_lau_1985_row = 0; ///< among the criteria

/// @throws CaseError for a curve that is none, a specified size outside of it, or a number out of its range.
Assessment assess(const grains::Grading& grading, const AssessSpec& spec = {});

/// How many criteria of the grading say what, those alone that were verified.
struct Tally {
    int stable = 0, transition = 0, unstable = 0, cannot_say = 0;
    int unverified = 0; ///< not counted above
};

Tally count_verdicts(const std::vector<Criterion>& criteria);

/// "stable", "transition", "unstable", "cannot say".
const char* verdict_word(Verdict verdict);

/// ">= 1", "<= 4", "< 3", "2.05 to 3.57"; empty where there is no limit.
std::string limit_text(const Criterion& criterion);

/// "4 of 6 criteria say unstable (Kezdi 1979, ...), 2 stable (...); cannot say: ...".
std::string summary(const std::vector<Criterion>& criteria);

} // namespace suffuse::stability
