#pragma once
// `do = "triaxial"`: compression along one axis from the state that the stage starts from. `do = "stress-probe"`: its
// answers to small loads of all directions.

#include <cstdint>
#include <optional>

namespace suffuse::triaxial {

enum class Path {
    Drained,          ///< lateral stresses held
    ConstantMean,     ///< mean stress held
    ConstantDeviator, ///< deviator stress of the start held while the cell widens: pore pressure rises
    Undrained,        ///< volume held
    Proportional,     ///< ratio of volumetric to axial strain held
};

enum class GrainInertia {
    Lent, ///< as compactions lend it, so that steps are longer: a quasi-static test does not depend on it
    Own,
};

struct TriaxialSpec {
    Path path = Path::Drained;
    GrainInertia inertia = GrainInertia::Lent; ///< a given time step, and a constant deviator, leave grains their own
    int axis = 2;                              ///< 0, 1, 2: the axis compressed
    double strain = 0.2;                ///< axial strain to stop at; constant deviator: or axial minus volumetric [-]
    std::optional<double> strain_ratio; ///< proportional: volumetric over axial strain; 1 is an oedometer [-]
    std::optional<double> deviator_stress; ///< q to stop at, then settle there; the strain is then a limit [Pa]
    std::optional<double> stress_ratio;    ///< q/p to stop at, instead [-]
    double inertial_number = 1e-3;         ///< sets the axial strain rate [-]
    double time_step = 0;                  ///< [s]; 0 = computed
    int rows = 400;                        ///< stress-strain rows recorded over the specified strain

    /// There it settles; else it ends at a strain.
    [[nodiscard]] bool stops_at_stress() const { return deviator_stress || stress_ratio; }
};

/// Loads of one size, in directions spaced equally over the plane of axisymmetric stress.
struct StressProbeSpec {
    int axis = 2; ///< 0, 1, 2: the axis of symmetry
    int directions = 24;
    double increment = 0.05;         ///< norm of the stress increment / mean stress [-]
    std::int64_t ramp = 1000;        ///< steps from none of it to all
    double unbalanced_force = 1e-5;  ///< of the state probed, and of each answer [-]
    double max_strain = 0.01;        ///< norm of a strain beyond which the sample counts as failing [-]
    std::int64_t max_steps = 30'000; ///< of a probe; a sample not at rest by then creeps
    double time_step = 0;            ///< [s]; 0 = computed
};

} // namespace suffuse::triaxial
