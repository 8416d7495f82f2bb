#pragma once
// How fast this machine advances grains, measured in a fraction of a second on a made-up packing: a jittered cubic
// lattice with about as many contacts a grain as a settled sand, stepped by the same code as a run.

#include "suffuse/dem/spec.hpp"

#include <cstdint>

namespace suffuse::plan {

struct MachineSpeed {
    double particle_steps_per_second = 0; ///< of one sample
    std::int64_t grains = 0;              ///< of the packing that was stepped
    int threads = 1;                      ///< of one sample
    int at_once = 1;                      ///< samples that run side by side
    double in_reference_mode = 0;         ///< the same in reference mode, where the case's is another; 0: it is not

    [[nodiscard]] double reference_speed() const {
        return in_reference_mode > 0 ? in_reference_mode : particle_steps_per_second;
    }
};

/// Steps about `grains` grains (between 500 and 50,000 are taken) for about `seconds` of wall time, in `at_once`
/// packings side by side, as a run of so many samples does.
MachineSpeed measure_speed(std::int64_t grains, dem::Mode mode, double seconds = 0.3, int at_once = 1);

} // namespace suffuse::plan
