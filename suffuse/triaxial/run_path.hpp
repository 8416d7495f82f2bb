#pragma once
// Triaxial compression from the state given: drained, at constant mean stress, or at constant volume. World in, rows
// out.

#include "suffuse/dem/settle.hpp"
#include "suffuse/triaxial/spec.hpp"

#include <optional>
#include <vector>

namespace suffuse::triaxial {

/// One row of the stress-strain curve.
struct PathRow {
    double axial_strain = 0;            ///< logarithmic, since the start of the test [-]
    double volumetric_strain = 0;       ///< compression positive [-]
    Mat3 stress;                        ///< [Pa]
    double mean_stress = 0;             ///< p [Pa]
    double deviator_stress = 0;         ///< q = axial minus mean lateral stress [Pa]
    double void_ratio = 0;              ///< [-]
    double coordination = 0;            ///< contacts per grain, twice the number over the grains [-]
    double mechanical_coordination = 0; ///< the same without rattlers [-]
    double unbalanced_force = 0;        ///< [-]
    double inertial_number = 0;         ///< [-]
    double second_order_work = 0;       ///< since the row before [J/m3]
    double excess_pore_pressure = 0;    ///< undrained: of the water, where the total lateral stress is held [Pa]
};

/// Where a test stands; part of what a checkpoint saves, with `rows`.
struct PathState {
    enum class Phase : std::int32_t { Shear, Settle, Done };

    Phase phase = Phase::Shear;
    Mat3 start_h;               ///< cell at the start of the test [m]
    Mat3 start_stress;          ///< [Pa]
    double strain_rate = 0;     ///< axial, compression positive [1/s]
    double median_diameter = 0; ///< by mass, of the inertial number [m]
    double time_step = 0;       ///< [s]
    dem::BalanceState balance;
    std::int64_t steps = 0;
    std::vector<PathRow> rows;
};

/// @param stress of the state that the test starts from [Pa]
/// @throws StateError when the sample carries none, CaseError when strain, inertial number or rows are not above zero.
PathState begin_path(dem::World& world, const TriaxialSpec& spec, const Mat3& stress, double time_step);

/// One burst of steps; appends a row when the strain has grown by the interval asked. @return whether the test is over.
/// @throws StateError when the stress asked for is not reached within the strain, or not held.
bool path_burst(
    dem::World& world, dem::StepCaches& caches, const TriaxialSpec& spec, const dem::BalanceSpec& balance,
    double damping, dem::Mode mode, PathState& state
);

/// Second-order work between two rows, d stress : d strain, for equal lateral strains [J/m3] [Hill 1958]
double second_order_work(const PathRow& before, const PathRow& after);

/// Where a sample would fail under loads instead of strains.
struct Instability {
    double deviator_stress = 0; ///< q [Pa]
    double mean_stress = 0;     ///< p [Pa]
    double axial_strain = 0;    ///< [-]
};

/// Peak strength, stiffness, dilatancy and instability of a curve.
struct Response {
    double peak_deviator = 0;                   ///< [Pa]
    double peak_strain = 0;                     ///< axial strain at the peak [-]
    double peak_ratio = 0;                      ///< q/p at the peak [-]
    double friction_angle = 0;                  ///< at the peak, sin = (s1 - s3)/(s1 + s3) [rad]
    double final_deviator = 0;                  ///< at the last row [Pa]
    double stiffness = 0;                       ///< secant E50: half the peak deviator over the strain there [Pa]
    double dilatancy = 0;                       ///< largest -d eps_v / d eps_1 after the first percent [-]
    double largest_contraction = 0;             ///< volumetric strain [-]
    double final_volumetric_strain = 0;         ///< [-]
    std::optional<Instability> instability;     ///< where the second-order work is first no longer above zero
    std::optional<bool> liquefied;              ///< undrained: whether the mean stress fell below 5 % of its start
    std::optional<double> excess_pore_pressure; ///< undrained: at the last row [Pa]
};

Response summarize(const std::vector<PathRow>& rows, Path path = Path::Drained);

} // namespace suffuse::triaxial
