#pragma once
// How well an emulated curve agrees with a measured one.

#include "suffuse/calibration/emulator.hpp"

#include <memory>
#include <vector>

namespace suffuse::calibration {

struct Measurement {
    std::vector<int> rows;         ///< of the emulated curve that were measured
    Curve values;                  ///< one a row
    std::vector<Curve> covariance; ///< of the values' errors, positive definite
    double weight = 1;             ///< of its log likelihood
};

/// Errors of a curve's values that decline with their distance: deviation of each, correlation exp(-|i - j|/range).
/// Rows from `begins` on have errors independent of those before: another quantity.
std::vector<Curve> correlated_errors(const Curve& deviations, const std::vector<int>& begins, double range);

class CurveFit {
public:
    /// @throws std::invalid_argument where sizes differ, or the covariance is not positive definite
    CurveFit(const CurveEmulator& emulator, Measurement measurement);

    /// Of the measured values where the unknowns are `point`, with the covariance of the errors plus that of the
    /// emulator. Student's t, for that covariance is itself estimated from the runs: values that no parameters reach
    /// say less than they would by a normal law. Without the constant, times the weight.
    [[nodiscard]] double log_likelihood(const Point& point) const;

    struct Parts;

private:
    std::shared_ptr<const Parts> parts_;
};

} // namespace suffuse::calibration
