#pragma once
// How near each sample of a calibration came to its test: what shows, before any emulator, where the model fits.

#include "suffuse/job/laboratory_curve.hpp"

#include <limits>
#include <string>
#include <vector>

namespace suffuse::job {

struct SampleFit {
    std::string round; ///< "round-1", "held-out"
    std::string target;
    int design = 0; ///< of its round, from 1
    double misfit = std::numeric_limits<double>::quiet_NaN();
    std::string failure;        ///< empty where it has a misfit
    std::vector<double> values; ///< one an unknown, in SI
};

/// Root mean square of curve - laboratory over the largest value of each measured part; of several parts the root mean
/// square of theirs [-]. @param curve simulated, all parts
double misfit_of(const std::vector<double>& curve, const LaboratoryCurve& laboratory);

} // namespace suffuse::job
