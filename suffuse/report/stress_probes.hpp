#pragma once
// How samples answer small loads in all directions, and the figure drawn from it. Inputs are SI.

#include "suffuse/report/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::report {

/// The answer to one load, in the plane of axisymmetric stress. Compression positive.
struct ProbedDirection {
    double angle = 0;                            ///< of the load, from lateral stress towards axial [rad]
    double normalized_work = 0;                  ///< second-order, -1 to 1 [-]
    double axial_stress = 0, lateral_stress = 0; ///< increments; lateral: of each of the two axes [Pa]
    double axial_strain = 0, lateral_strain = 0; ///< [-]
    std::string answer = "rests";                ///< or "creeps", "fails"
};

struct ProbedSample {
    std::string name;
    std::vector<ProbedDirection> directions;
};

/// Where a sample is least stable, and in which directions it is not; one sentence.
std::string tell_stability(const ProbedSample& sample);

/// Ours: the second-order work of each direction, and the strains that the loads lead to.
std::optional<Figure> stability_in_directions(const std::vector<ProbedSample>& samples);

} // namespace suffuse::report
