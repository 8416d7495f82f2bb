#pragma once
// Beyond its peak a test shows what is left: the deviator stress at a strain, and that of the critical state, in which
// the sample shears on with nothing changing any more. Whether a test was long enough to see it is judged, not assumed.

#include "suffuse/triaxial/run_path.hpp"

#include <optional>
#include <vector>

namespace suffuse::study {

/// The last part of a test.
struct EndOfTest {
    double deviator = 0;   ///< mean of q over it [Pa]
    double mean_ratio = 0; ///< mean of q/p [-]
    double void_ratio = 0; ///< mean [-]
    double dilation = 0;   ///< -d eps_v/d eps_1, by a straight line [-]
    double drift = 0;      ///< change of q over it, by a straight line, over its mean [-]

    /// Neither volume nor strength goes on changing.
    [[nodiscard]] bool is_critical() const;
};

inline constexpr double critical_window = 0.1; ///< axial strain that the last part spans [-]

/// Nothing for a test shorter than twice the window: its last part would be its beginning too.
std::optional<EndOfTest> end_of_test(const std::vector<triaxial::PathRow>& rows);

/// q at an axial strain, between the two rows about it; not a number beyond the last one [Pa].
double deviator_at(const std::vector<triaxial::PathRow>& rows, double axial_strain);

} // namespace suffuse::study
