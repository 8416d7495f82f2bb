#pragma once
// How states answer small loads in all directions, and the figure drawn from it. Inputs are SI.

#include "suffuse/report/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::report {

/// The answer to one load, in the plane of axisymmetric stress; the mean over samples that differ in their seed only.
/// Compression positive.
struct ProbedDirection {
    double angle = 0;                            ///< of the load, from lateral stress towards axial [rad]
    double normalized_work = 0;                  ///< second-order, -1 to 1 [-]
    double axial_stress = 0, lateral_stress = 0; ///< increments; lateral: of each of the two axes [Pa]
    double axial_strain = 0, lateral_strain = 0; ///< [-]
    int unstable = 0;                            ///< samples that fail, or whose work is not above zero
};

struct ProbedState {
    std::string name;
    std::vector<ProbedDirection> directions;
    int samples = 1;
};

/// Where a state is least stable, and in which directions it is not; one sentence.
std::string tell_stability(const ProbedState& state);

/// Ours: the second-order work of each direction, and the strains that the loads lead to.
std::optional<Figure> stability_in_directions(const std::vector<ProbedState>& states);

} // namespace suffuse::report
