#pragma once
// What fines of weight cost: a rest, and a ramp of gradients, each with a flow of its own.

#include "suffuse/base/range.hpp"

#include <algorithm>

namespace suffuse::plan {

/// Steps of the rest and of one gradient of the ramp: so that all 29 ramps of validation/critical_gradient.toml and
/// examples/critical-gradient, of 12, 16 and 24 gradients, lie within; dense soils of size ratio 3.5 are at the lower
/// end, ratio 10 at the upper.
inline constexpr Range rest_under_weight{20'000, 80'000}, gradient_borne{4'500, 16'000};

/// Work of such a step, over that of a step of the whole sample: only what is free moves.
inline constexpr Range work_of_free_fines{0.4, 1.2};

inline Range steps_with_weight(double gradients) {
    return rest_under_weight + gradients * gradient_borne;
}

} // namespace suffuse::plan
