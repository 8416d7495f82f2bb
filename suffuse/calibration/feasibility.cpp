#include "suffuse/calibration/feasibility.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::calibration {
namespace {

constexpr double least = 0.2;  // a sample of other grains may succeed where these failed
constexpr double reach = 0.15; // of the cube's side: a run speaks for its neighborhood

/// Weight of the runs near `point`.
double nearby(const std::vector<Point>& runs, const Point& point) {
    double sum = 0;
    for (const Point& run : runs) {
        double square = 0;
        for (std::size_t d = 0; d < point.size(); ++d) {
            square += (run[d] - point[d]) * (run[d] - point[d]);
        }
        sum += std::exp(-0.5 * square / (reach * reach));
    }
    return sum;
}

} // namespace

Feasibility::Feasibility(std::vector<Point> succeeded, std::vector<Point> failed)
    : succeeded_(std::move(succeeded)), failed_(std::move(failed)) {}

double Feasibility::chance(const Point& point) const {
    if (failed_.empty()) {
        return 1;
    }
    const double good = 0.1 + nearby(succeeded_, point);
    return std::max(least, good / (good + nearby(failed_, point)));
}

} // namespace suffuse::calibration
