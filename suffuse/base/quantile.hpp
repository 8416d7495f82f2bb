#pragma once
// Quantiles of a sample: linear between order statistics (type 7 of Hyndman and Fan 1996); or a value that the sample
// has, where that of a grain is meant.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace suffuse {

/// The `share` quantile of values sorted upward; not a number for an empty sample.
inline double quantile_of_sorted(std::span<const double> sorted, double share) {
    if (sorted.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double rank = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(rank));
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (rank - std::floor(rank)) * (sorted[above] - sorted[below]);
}

inline double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return quantile_of_sorted(values, share);
}

/// The next order statistic from there on: of an even number of values the median is the upper of the two in the
/// middle.
inline double upper_quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

} // namespace suffuse
