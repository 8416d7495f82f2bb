#pragma once
// Force on each grain from outside the skeleton: how the fluid reaches the grains without `dem` knowing of fluid.

#include "suffuse/base/vec3.hpp"

#include <vector>

namespace suffuse::grains {

struct GrainLoad {
    std::vector<Vec3> force; ///< one row a grain, in the order of the grain table; empty means none [N]
};

} // namespace suffuse::grains
