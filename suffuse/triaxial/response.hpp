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
    double largest_contraction = 0;     ///< volumetric strain [-]
    double final_volumetric_strain = 0; ///< [-]
    std::optional<double>
        stiffness; ///< secant E50 to half the growth of q; nothing where q is held or never grows [Pa]
    std::optional<double>
        dilatancy; ///< largest -d eps_v / d eps_1 over one percent of strain; nothing of less strain [-]
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

inline constexpr double good_hold_error = 0.02; ///< in every row [-]

/// How far the stress that a test holds and that is furthest off was off in the worst row, over it [-]; nothing of
/// paths that hold none, nor of the constant deviator.
std::optional<double> find_hold_error(const std::vector<PathRow>& rows, Path path);

/// Of extension, the deviator stress and the axial strain are below zero; its peak is where q is lowest.
Response summarize(const std::vector<PathRow>& rows, const TriaxialSpec& spec);

inline Response summarize(const std::vector<PathRow>& rows, Path path = Path::Drained) {
    return summarize(rows, TriaxialSpec{.path = path});
}

} // namespace suffuse::triaxial
