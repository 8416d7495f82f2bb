#include "suffuse/calibration/interval.hpp"

#include "suffuse/base/quantile.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::calibration {
namespace {

constexpr double edge = 0.02;               // of the range: the slice at a bound
constexpr double piled_up = 0.1;            // share of the samples there; of a prior it is that of the slice
constexpr double tail = 0.05;               // on either side of an interval
constexpr double prior_variance = 1.0 / 12; // of a coordinate of the cube

double bits(double variance) {
    return std::max(0.0, 0.5 * std::log2(prior_variance / std::max(variance, std::numeric_limits<double>::min())));
}

std::vector<double> coordinate(const std::vector<Point>& samples, std::size_t d) {
    std::vector<double> values;
    values.reserve(samples.size());
    for (const Point& sample : samples) {
        values.push_back(sample[d]);
    }
    return values;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Bound bound_of(const std::vector<double>& values) {
    double low = 0, high = 0;
    for (const double value : values) {
        low += value < edge ? 1 : 0;
        high += value > 1 - edge ? 1 : 0;
    }
    const double least = piled_up * static_cast<double>(values.size());
    return low < least && high < least ? Bound::None : low >= high ? Bound::Low : Bound::High;
}

} // namespace

std::vector<Interval> intervals_of(const std::vector<Point>& samples) {
    std::vector<Interval> intervals;
    const std::size_t dimensions = samples.empty() ? 0 : samples.front().size();
    intervals.reserve(dimensions);
    for (std::size_t d = 0; d < dimensions; ++d) {
        const std::vector<double> values = coordinate(samples, d);
        Interval interval{mean_of(values), quantile(values, tail), quantile(values, 1 - tail), 1, bound_of(values), 0};
        interval.width = (interval.high - interval.low) / (1 - 2 * tail);
        double squares = 0;
        for (const double value : values) {
            squares += (value - interval.mean) * (value - interval.mean);
        }
        interval.information = bits(squares / static_cast<double>(values.size()));
        intervals.push_back(interval);
    }
    return intervals;
}

std::vector<double> information_of_data(
    const std::vector<Point>& samples, const std::function<std::vector<std::vector<double>>(const Point&)>& fisher
) {
    const auto n = static_cast<Eigen::Index>(samples.empty() ? 0 : samples.front().size());
    std::vector<double> mean(static_cast<std::size_t>(n), 0.0);
    for (const Point& sample : samples) {
        const std::vector<std::vector<double>> rows = fisher(sample);
        Eigen::MatrixXd precision = Eigen::MatrixXd::Identity(n, n) / prior_variance;
        for (Eigen::Index i = 0; i < n; ++i) {
            precision.row(i) += Eigen::Map<const Eigen::RowVectorXd>(rows[static_cast<std::size_t>(i)].data(), n);
        }
        const Eigen::VectorXd variances = precision.llt().solve(Eigen::MatrixXd::Identity(n, n)).diagonal();
        for (Eigen::Index i = 0; i < n; ++i) {
            mean[static_cast<std::size_t>(i)] += bits(variances[i]) / static_cast<double>(samples.size());
        }
    }
    return mean;
}

std::vector<std::vector<double>> correlations_of(const std::vector<Point>& samples) {
    const std::size_t dimensions = samples.empty() ? 0 : samples.front().size();
    std::vector<std::vector<double>> deviations, correlations(dimensions, std::vector<double>(dimensions, 0.0));
    for (std::size_t d = 0; d < dimensions; ++d) {
        std::vector<double> values = coordinate(samples, d);
        const double mean = mean_of(values);
        for (double& value : values) {
            value -= mean;
        }
        deviations.push_back(std::move(values));
    }
    const auto product = [&](std::size_t a, std::size_t b) {
        return std::inner_product(deviations[a].begin(), deviations[a].end(), deviations[b].begin(), 0.0);
    };
    for (std::size_t a = 0; a < dimensions; ++a) {
        for (std::size_t b = 0; b < dimensions; ++b) {
            const double norm = std::sqrt(product(a, a) * product(b, b));
            correlations[a][b] = a == b ? 1.0 : norm > 0 ? product(a, b) / norm : 0.0;
        }
    }
    return correlations;
}

} // namespace suffuse::calibration
