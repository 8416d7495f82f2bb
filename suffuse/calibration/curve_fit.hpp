#pragma once
// How well emulated curves agree with measured ones, all tests of a laboratory at once. The curves are compared by a
// few weighted sums of their values, those that tell parameters best from errors; the covariance of the sums, over the
// values of a curve and over curves, is that of the runs which were left out [docs/theory/calibration.md].

#include "suffuse/calibration/emulator.hpp"

#include <memory>
#include <vector>

namespace suffuse::calibration {

struct Measurement {
    std::vector<int> rows;   ///< of the emulated curve that were measured
    Curve values;            ///< one a row
    Curve deviations;        ///< of the values' own errors, above 0
    std::vector<int> begins; ///< first row of each quantity but the first: quantities have independent errors
    double weight = 1;       ///< as if the variance of all of its errors were divided by it
};

/// A test that is fitted.
struct FittedTest {
    CurveEmulator emulator;
    std::vector<int> runs;     ///< a number for each run of the emulator: the same in all tests for the same unknowns
    std::vector<int> unknowns; ///< coordinates of a point on which the test depends, in the order of the emulator
    Measurement measured;
};

/// Errors of a curve's values that decline with their distance: deviation of each, correlation exp(-|i - j|/range).
/// Rows from `begins` on have errors independent of those before: another quantity.
std::vector<Curve> correlated_errors(const Curve& deviations, const std::vector<int>& begins, double range);

/// Of a measurement's own errors, in rows.
inline constexpr double range_of_errors = 3;

class CurveFit {
public:
    /// @throws std::invalid_argument where sizes differ, or a deviation is not above 0
    explicit CurveFit(const std::vector<FittedTest>& tests);

    /// Of the sums where the unknowns are `point`: Student's t, for their covariance is itself estimated from the runs.
    /// Without the constant.
    [[nodiscard]] double log_likelihood(const Point& point) const;

    /// Fisher's information of the data about the unknowns, a row an unknown.
    [[nodiscard]] std::vector<Curve> information(const Point& point) const;

    /// How many sums of values are compared.
    [[nodiscard]] int sums() const;

    struct Parts;

private:
    std::shared_ptr<const Parts> parts_;
};

} // namespace suffuse::calibration
