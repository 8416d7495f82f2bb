#include "suffuse/figures/line_fit.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/student.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::figures {
namespace {

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

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
    fit.half_width = student_90(x.size() - 2) * fit.scatter / std::sqrt(xx);
    return fit;
}

} // namespace suffuse::figures
