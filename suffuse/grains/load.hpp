#pragma once
// Force on each grain from outside the skeleton: how the fluid reaches the grains without `dem` knowing of fluid.

#include "suffuse/base/vec3.hpp"

#include <vector>

namespace suffuse::grains {

struct GrainLoad {
    std::vector<Vec3> force;  ///< one row a grain, in the order of the grain table; empty means none [N]
    std::vector<double> drag; ///< of each grain, over the step's viscous drag; empty means 1 [-]
};

} // namespace suffuse::grains
