#pragma once
// What samples of the posterior say of each unknown, in the unit cube.

#include "suffuse/calibration/posterior.hpp"

#include <functional>
#include <vector>

namespace suffuse::calibration {

/// Bits that data must give of an unknown to identify it: 1 halves the deviation that its range leaves. Two unknowns of
/// which the data fix only the sum have half a bit each, for they share one measurement.
inline constexpr double identified_from = 1;

enum class Bound { None, Low, High };

struct Interval {
    double mean = 0, low = 0, high = 0; ///< quantiles of 5 and 95 %
    double width = 1;                   ///< of the interval / that of the prior
    Bound bound = Bound::None;          ///< the end of its range at which the samples pile up
    double information = 0;             ///< log2(deviation of its range / deviation of the samples) [bit]

    [[nodiscard]] bool is_identified() const { return information >= identified_from; }
};

std::vector<Interval> intervals_of(const std::vector<Point>& samples);

/// What the data by themselves say of each unknown: the same information where the posterior is normal with Fisher's
/// information `fisher` and the variance of the ranges, its mean over `samples`. Samples on a ridge that two ends of
/// ranges cut short lie closer together than this says. [bit]
std::vector<double> information_of_data(
    const std::vector<Point>& samples, const std::function<std::vector<std::vector<double>>(const Point&)>& fisher
);

/// Pearson's, a row an unknown; 1 on the diagonal.
std::vector<std::vector<double>> correlations_of(const std::vector<Point>& samples);

} // namespace suffuse::calibration
