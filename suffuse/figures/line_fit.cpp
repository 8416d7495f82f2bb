#include "suffuse/figures/line_fit.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::figures {
namespace {

constexpr double confidence = 0.9;

/// The t within which Student's lies with that confidence.
double student_bound(std::size_t freedom) {
    double low = 0, high = 10; // one degree of freedom: 6.3
    constexpr int halvings = 60;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (low + high);
        (student_within(middle, freedom) < confidence ? low : high) = middle;
    }
    return high;
}

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

double student_within(double t, std::size_t freedom) {
    const double angle = std::atan(t / std::sqrt(static_cast<double>(freedom)));
    const double c2 = std::cos(angle) * std::cos(angle);
    const bool is_odd = freedom % 2 == 1;
    double term = is_odd ? std::cos(angle) : 1, sum = freedom > 1 ? term : 0;
    for (std::size_t k = is_odd ? 3 : 2; k + 1 < freedom; k += 2) { // from the power of the cosine before
        term *= c2 * static_cast<double>(k - 1) / static_cast<double>(k);
        sum += term;
    }
    return is_odd ? 2 / pi * (angle + std::sin(angle) * sum) : std::sin(angle) * sum;
}

LineFit fit_line(std::span<const double> x, std::span<const double> y) {
    expects(x.size() == y.size(), "a point has two coordinates");
    LineFit fit{.points = x.size(), .half_width = std::numeric_limits<double>::infinity()};
    if (x.empty()) {
        return fit;
    }
    const double middle = mean(x), level = mean(y);
    double xx = 0, xy = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        xx += (x[k] - middle) * (x[k] - middle);
        xy += (x[k] - middle) * (y[k] - level);
    }
    fit.slope = xx > 0 ? xy / xx : 0;
    fit.intercept = level - fit.slope * middle;
    if (x.size() < 3 || !(xx > 0)) {
        return fit;
    }
    double squares = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double off = y[k] - fit.intercept - fit.slope * x[k];
        squares += off * off;
    }
    fit.scatter = std::sqrt(squares / static_cast<double>(x.size() - 2));
    fit.half_width = student_bound(x.size() - 2) * fit.scatter / std::sqrt(xx);
    return fit;
}

} // namespace suffuse::figures
