#pragma once
// Where to simulate next: of samples of the posterior, those at which the emulators know the curves least.

#include "suffuse/calibration/sobol.hpp"

#include <functional>
#include <vector>

namespace suffuse::calibration {

/// Picks `count` of `candidates`, one after the other: each has the largest product of `uncertainty` and its distance
/// to the nearest point of `known` and of those picked.
/// @param uncertainty of the emulators at a point, from 0
std::vector<Point> next_designs(
    const std::vector<Point>& candidates, int count, const std::vector<Point>& known,
    const std::function<double(const Point&)>& uncertainty
);

/// Whether another round would change little: intervals whose mean width was `before` and is `after` a round differ by
/// less than 5 %. A round that widens them has shown that those before it knew too little, and is not the last.
bool has_settled(double before, double after);

} // namespace suffuse::calibration
