#pragma once
// Which grains of a packing that was not drawn from the soil's curves are fine: by size, where the soil has a limit.

#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/grains.hpp"

#include <optional>

namespace suffuse::run {

inline void mark_fines(const std::optional<grains::Soil>& soil, grains::Grains& grains) {
    if (!soil) {
        return;
    }
    std::optional<double> limit = soil->finer_than;
    if (soil->kenney_lau && soil->whole) {
        limit = grains::kenney_lau_split(*soil->whole);
    }
    if (!limit) {
        return;
    }
    for (std::size_t g = 0; g < grains.size(); ++g) {
        grains.fine[g] = 2 * grains.radius[g] < *limit ? 1 : 0;
    }
}

} // namespace suffuse::run
