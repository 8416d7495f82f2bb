#pragma once
// The inside of an emulator, for the files of this room.

#include "suffuse/calibration/emulator.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Dense>

namespace suffuse::calibration {

/// What an emulator assumes of the cube.
struct Smoothness {
    int degree = 2;         ///< of the trend: 0, 1, 2
    double share = 0;       ///< variance of the process / scatter between runs
    double correlation = 1; ///< length, of a cube from -1 to 1
};

struct CurveEmulator::Parts {
    Eigen::MatrixXd points; ///< a row a run, from -1 to 1
    Smoothness smoothness;
    Eigen::MatrixXd basis;   ///< terms of the trend, a row a run
    Eigen::VectorXd center;  ///< mean curve
    Eigen::MatrixXd weights; ///< inverse covariance times curves
    Eigen::MatrixXd trend;   ///< coefficients, a row a term
    Eigen::LLT<Eigen::MatrixXd> factor;
    Eigen::MatrixXd fitted;          ///< emulated curves of the runs, minus `center`
    Eigen::MatrixXd left_out;        ///< errors, a row a run
    Eigen::MatrixXd standard_errors; ///< the same, as they would be at variance 1

    struct Prediction {
        Eigen::VectorXd mean;
        double variance = 1;
    };

    [[nodiscard]] Prediction predict(const Point& point) const;

    /// An emulator of weighted sums of `rows`, a column of `sums` each: it is linear in the curves.
    [[nodiscard]] Parts summed(const std::vector<int>& rows, const Eigen::MatrixXd& sums) const;
};

Eigen::VectorXd inner_point(const Point& point);

} // namespace suffuse::calibration
