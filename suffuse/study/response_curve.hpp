#pragma once
// Stress-strain curves of triaxial tests. Compression and contraction positive.

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

/// One row of a triaxial test.
struct StressStrainRow {
    double axial_strain = 0, volumetric_strain = 0; ///< [-]
    double deviator_stress = 0, mean_stress = 0;    ///< q, p [Pa]
    double void_ratio = 0;                          ///< [-]
    double excess_pore_pressure = 0;                ///< where the test has one [Pa]
};

/// A test, or the mean over tests of samples that differ in their seed only.
struct ResponseCurve {
    std::string name; ///< "before erosion", "FC 10 %"
    std::vector<StressStrainRow> rows;
    std::vector<StressStrainRow> deviation = {}; ///< standard deviation over the samples; empty for one
    int samples = 1;
    double fines_content = std::numeric_limits<double>::quiet_NaN(); ///< where that is swept: gives its color [-]
    /// Where the pore pressure rises at a constant deviator stress: the most that the sample bears [Pa]
    std::optional<double> borne_pore_pressure = std::nullopt;
};

/// The mean over `of_sample`, at the axial strains of the first of them as far as all reach, linear between rows; where
/// the deviator is held at its widening first, axial minus volumetric strain, for a sample then lengthens.
ResponseCurve average_response(
    const std::string& name, const std::vector<std::vector<StressStrainRow>>& of_sample, bool holds_deviator = false
);

} // namespace suffuse::study
