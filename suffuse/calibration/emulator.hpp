#pragma once
// Curves that a simulation gave at some points of the unit cube -> the curve at any other point, with its error: a
// polynomial trend and a Gaussian process of what it leaves [Rasmussen and Williams 2006, 2.7]. All rows of a curve
// share the covariance in the cube; the size of the errors is that of the runs when each is left out in turn.

#include "suffuse/calibration/sobol.hpp"

#include <memory>
#include <vector>

namespace suffuse::calibration {

/// Numbers of one test, in an order that all curves share.
using Curve = std::vector<double>;

class CurveEmulator {
public:
    /// Trend, correlation length and share of the process are those whose errors of leaving one out are the likeliest.
    /// @param points at least four, all of the same dimension; `curves` one a point, all of the same size
    CurveEmulator(const std::vector<Point>& points, const std::vector<Curve>& curves);

    [[nodiscard]] Curve mean(const Point& point) const;

    /// Of the run at `point`, scatter between runs included: times row_variance it is the variance of a row. At least
    /// 1, which is the scatter alone.
    [[nodiscard]] double variance(const Point& point) const;

    /// Of a row where `variance` is 1.
    [[nodiscard]] double row_variance(int row) const;

    /// Root mean square of the errors of each row when a run is left out.
    [[nodiscard]] Curve left_out_errors() const;

    [[nodiscard]] int rows() const;

    /// Runs beyond the terms of the trend, at least 4: from so many follows the covariance of errors.
    [[nodiscard]] double degrees_of_freedom() const;

    struct Parts;

    [[nodiscard]] const Parts& parts() const { return *parts_; } ///< emulator_parts.hpp

private:
    std::shared_ptr<const Parts> parts_;
};

} // namespace suffuse::calibration
