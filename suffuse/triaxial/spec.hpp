#pragma once
// `do = "triaxial"`: compression along one axis from the state that the stage starts from.

#include <optional>

namespace suffuse::triaxial {

enum class Path {
    Drained,      ///< lateral stresses held
    ConstantMean, ///< mean stress held
    Undrained,    ///< volume held
};

struct TriaxialSpec {
    Path path = Path::Drained;
    int axis = 2;                          ///< 0, 1, 2: the axis compressed
    double strain = 0.2;                   ///< axial strain to stop at [-]
    std::optional<double> deviator_stress; ///< q to stop at, then settle there; the strain is then a limit [Pa]
    std::optional<double> stress_ratio;    ///< q/p to stop at, instead [-]
    double inertial_number = 1e-3;         ///< sets the axial strain rate [-]
    double time_step = 0;                  ///< [s]; 0 = computed
    int rows = 400;                        ///< stress-strain rows recorded over the asked strain
};

} // namespace suffuse::triaxial
