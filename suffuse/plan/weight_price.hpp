#pragma once
// What fines of weight cost: a rest, and a ramp of gradients, each with a flow of its own.

#include "suffuse/base/range.hpp"
#include "suffuse/erosion/refined_ramp.hpp"
#include "suffuse/erosion/spec.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace suffuse::plan {

/// Work of a step under weight, over that of a step of the whole sample: only what is free moves.
inline constexpr Range work_of_free_fines{0.4, 1.2};

/// Levels of a ramp between those that are given, but for what the search of the gradients that move 1 and 10 % adds.
inline double levels_of_ramp(std::vector<double> gradients) {
    constexpr double about_heave = 1;
    return static_cast<double>(erosion::RefinedRamp(std::move(gradients), about_heave, {}).given_count());
}

/// Steps. @param sifts whether fines fall through the skeleton on and on, so that they may never rest
inline Range rest_of_fines(bool sifts) {
    return {20'000, sifts ? 800'000.0 : 80'000.0};
}

/// Steps of a rest and a ramp. Those of a level, with its share of the search, lie between 4,500 and 16,000 under a
/// hold of 20 units of time at most. Only a part of the levels uses up a longer one: those under which fines creep.
inline Range steps_with_weight(double levels, const erosion::WeighedMotion& motion, bool sifts) {
    constexpr Range level{4'500, 16'000};
    const double longer = motion.hold_at_most / 20;
    const double slower = std::sqrt(erosion::WeighedMotion{}.softness / motion.softness); // less force, less speed
    return slower * (rest_of_fines(sifts) + levels * std::min(longer, std::sqrt(longer)) * level);
}

/// Flows that are solved: one for each level, and anew after every 20 units of time of a long hold.
inline Range flows_with_weight(double levels, const erosion::WeighedMotion& motion) {
    return {levels, levels * (1 + motion.hold_at_most / 40)};
}

} // namespace suffuse::plan
