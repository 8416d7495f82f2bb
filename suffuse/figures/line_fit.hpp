#pragma once
// A straight line through scattered points by least squares, and whether they carry one.

#include <cstddef>
#include <span>

namespace suffuse::figures {

/// y = intercept + slope x.
struct LineFit {
    std::size_t points = 0;
    double slope = 0, intercept = 0;
    double half_width = 0; ///< of the 90 % interval of the slope, by Student's t; infinite with two points or fewer
    double scatter = 0;    ///< standard deviation of the points around the line

    static constexpr std::size_t fewest = 4; ///< points: with three, one of them decides

    /// Whether the points carry a line: they are enough, and the interval of the slope excludes 0.
    [[nodiscard]] bool is_carried() const {
        return points >= fewest && (slope - half_width > 0 || slope + half_width < 0);
    }
};

/// @param x and y of as many points. Slope 0 where all x are one.
LineFit fit_line(std::span<const double> x, std::span<const double> y);

} // namespace suffuse::figures
