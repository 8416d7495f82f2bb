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

} // namespace suffuse::calibration
