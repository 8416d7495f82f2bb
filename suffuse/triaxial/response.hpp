#pragma once
// What is read off a stress-strain curve: strength, stiffness, dilatancy, instability. Rows in, numbers out.

#include "suffuse/triaxial/run_path.hpp"

#include <optional>
#include <vector>

namespace suffuse::triaxial {

/// Where a sample would fail under loads instead of strains.
struct Instability {
    double deviator_stress = 0; ///< q [Pa]
    double mean_stress = 0;     ///< p [Pa]
    double axial_strain = 0;    ///< [-]
};

/// Peak strength, stiffness, dilatancy and instability of a curve. The peak is that of q; at a constant
/// deviator that of the pore pressure, until q is lost.
struct Response {
    double peak_deviator = 0;           ///< q there [Pa]
    double peak_strain = 0;             ///< axial strain at the peak [-]
    double peak_ratio = 0;              ///< q/p at the peak [-]
    double friction_angle = 0;          ///< at the peak, sin = (s1 - s3)/(s1 + s3) [rad]
    double final_deviator = 0;          ///< at the last row [Pa]
    double stiffness = 0;               ///< secant E50: half the peak deviator over the strain there; 0: none [Pa]
    double dilatancy = 0;               ///< largest -d eps_v / d eps_1 over one percent of strain [-]
    double largest_contraction = 0;     ///< volumetric strain [-]
    double final_volumetric_strain = 0; ///< [-]
    /// Drained, constant mean: axial strain at which the stress held was lost, for the sample gave way faster than a
    /// servo may follow; what comes later is no test of this path [-]
    std::optional<double> lost_at;
    std::optional<Instability> instability; ///< where the second-order work is first no longer above zero
    /// Undrained, constant deviator: whether the mean stress fell below 5 % of its start
    std::optional<bool> liquefied;
    /// Undrained: at the last row; constant deviator: the most that the sample bears [Pa]
    std::optional<double> excess_pore_pressure;
    dem::EnergyParts energy; ///< at the last row, over the volume at the start [J/m3]
};

/// How far the stress that a test holds was from its value at the start, over it [-].
struct HoldError {
    double most = 0;
    double usual = 0; ///< in 19 of 20 rows at most
};

inline constexpr double good_hold_error = 0.02; ///< in 19 of 20 rows [-]

/// Of the lateral stress of a drained test, of the mean stress of one that holds it; nothing of other paths.
std::optional<HoldError> find_hold_error(const std::vector<PathRow>& rows, Path path);

Response summarize(const std::vector<PathRow>& rows, Path path = Path::Drained);

} // namespace suffuse::triaxial
