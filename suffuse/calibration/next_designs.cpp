#include "suffuse/calibration/next_designs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::calibration {
namespace {

constexpr double least_change = 0.05; // of the mean interval: a round that gives less is the last

double square_distance(const Point& a, const Point& b) {
    double sum = 0;
    for (std::size_t d = 0; d < a.size(); ++d) {
        sum += (a[d] - b[d]) * (a[d] - b[d]);
    }
    return sum;
}

} // namespace

std::vector<Point> next_designs(
    const std::vector<Point>& candidates, int count, const std::vector<Point>& known,
    const std::function<double(const Point&)>& uncertainty
) {
    std::vector<double> unsure, nearest(candidates.size(), std::numeric_limits<double>::max());
    unsure.reserve(candidates.size());
    for (const Point& candidate : candidates) {
        unsure.push_back(uncertainty(candidate));
    }
    const auto approach = [&](const Point& point) {
        for (std::size_t k = 0; k < candidates.size(); ++k) {
            nearest[k] = std::min(nearest[k], square_distance(candidates[k], point));
        }
    };
    std::for_each(known.begin(), known.end(), approach);
    std::vector<Point> picked;
    picked.reserve(static_cast<std::size_t>(count));
    while (static_cast<int>(picked.size()) < count && !candidates.empty()) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < candidates.size(); ++k) {
            const auto worth = [&](std::size_t i) { return unsure[i] * unsure[i] * nearest[i]; };
            best = worth(k) > worth(best) ? k : best;
        }
        picked.push_back(candidates[best]);
        approach(picked.back());
    }
    return picked;
}

bool has_settled(double before, double after) {
    return std::abs(after - before) < least_change * before;
}

} // namespace suffuse::calibration
