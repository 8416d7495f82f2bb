#pragma once
// What fines of weight cost: a rest, and a ramp of gradients, each with a flow of its own.

#include "suffuse/base/range.hpp"

#include <algorithm>

namespace suffuse::plan {

/// Steps of the rest and of one gradient of the ramp, seen on gap-graded soils and sands of 2,000 to 10,000 grains: 30
/// to 200 and 4 to 20 units of time, each of 500 to 700 steps.
inline constexpr Range rest_under_weight{15'000, 120'000}, gradient_borne{2'000, 12'000};

/// Work of such a step, over that of a step of the whole sample: only what is free moves.
inline constexpr Range work_of_free_fines{0.4, 1.2};

inline Range steps_with_weight(double gradients) {
    return rest_under_weight + gradients * gradient_borne;
}

} // namespace suffuse::plan
