#pragma once
// How good the mechanics of each stage is: what reviewers look at first, against the limits in force.

#include "suffuse/report/numbering.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace suffuse::report {

/// A measure and the most that it may be; not a number where the stage has none, or no limit.
struct Measured {
    double value = std::numeric_limits<double>::quiet_NaN();
    double limit = std::numeric_limits<double>::quiet_NaN();

    [[nodiscard]] bool is_beyond() const { return value > limit; } ///< false without a limit
};

/// One line of the table. What a stage does not know is not a number.
struct StageRow {
    std::string name;
    std::int64_t grains = 0;
    double void_ratio = 0, porosity = 0;         ///< [-]
    double coordination = 0;                     ///< mean contacts a grain [-]
    double mean_stress = 0, deviator_stress = 0; ///< [Pa]
    Measured unbalanced_force;                   ///< mean resultant over mean contact force [-]
    Measured stress_error;                       ///< largest error of a specified stress, over that stress [-]
    Measured overlap;                            ///< largest, over the smaller radius [-]
    Measured inertial_number;                    ///< largest of the stage [-]
    double kinetic_share = std::numeric_limits<double>::quiet_NaN(); ///< kinetic energy over p V [-]
    double time_step = 0;                                            ///< [s]; 0 where nothing moved
    std::int64_t steps = 0;
    double seconds = 0; ///< wall time [s]
};

/// Two tables, state and quality, with a sentence on the limits and on conventions: HTML.
std::string quality_section(const std::vector<StageRow>& stages, Numbering& numbering);

} // namespace suffuse::report
