#pragma once
// What the stages with stress probes of a run found, as the report shows it.

#include "suffuse/record/finished_stage.hpp"

#include <string>
#include <vector>

namespace suffuse::study {

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

/// The mean over the seeds of each such stage at each set of swept values; the first ones, as many as a figure can
/// show.
std::vector<ProbedState> gather_probed_states(const std::vector<record::FinishedStage>& stages);

} // namespace suffuse::study
