#pragma once
// What samples of the posterior say of each unknown, in the unit cube.

#include "suffuse/calibration/posterior.hpp"

#include <vector>

namespace suffuse::calibration {

/// Of the width of the prior's 90 % interval: a wider one has learned little from the data. A ridge between two
/// unknowns that replace each other still halves the intervals of both.
inline constexpr double identified_below = 0.4;

enum class Bound { None, Low, High };

struct Interval {
    double mean = 0, low = 0, high = 0; ///< quantiles of 5 and 95 %
    double width = 1;                   ///< of the interval / that of the prior
    Bound bound = Bound::None;          ///< the end of its range at which the samples pile up

    [[nodiscard]] bool is_identified() const { return width < identified_below; }
};

std::vector<Interval> intervals_of(const std::vector<Point>& samples);

/// Pearson's, a row an unknown; 1 on the diagonal.
std::vector<std::vector<double>> correlations_of(const std::vector<Point>& samples);

} // namespace suffuse::calibration
