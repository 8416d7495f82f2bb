#include "suffuse/calibration/curve_fit.hpp"

#include "suffuse/calibration/emulator_parts.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace suffuse::calibration {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// In the axes W in which the errors are independent of size 1 and those of the emulator are too: W' C W = 1,
/// W' S W = diag(lambda). There a likelihood is a sum.
struct CurveFit::Parts {
    CurveEmulator emulator;
    std::vector<int> rows;
    VectorXd values;
    MatrixXd axes;
    VectorXd lambda;
    double weight = 1, freedom = 1;
};

std::vector<Curve> correlated_errors(const Curve& deviations, const std::vector<int>& begins, double range) {
    const std::size_t n = deviations.size();
    const auto part_of = [&](std::size_t row) {
        return std::count_if(begins.begin(), begins.end(), [&](int begin) { return static_cast<int>(row) >= begin; });
    };
    std::vector<Curve> covariance(n, Curve(n, 0.0));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            if (part_of(i) == part_of(j)) {
                const double distance = std::abs(static_cast<double>(i) - static_cast<double>(j));
                covariance[i][j] = deviations[i] * deviations[j] * std::exp(-distance / range);
            }
        }
    }
    return covariance;
}

CurveFit::CurveFit(const CurveEmulator& emulator, Measurement measurement) {
    const auto n = static_cast<Index>(measurement.rows.size());
    if (n == 0 || measurement.values.size() != measurement.rows.size() ||
        measurement.covariance.size() != measurement.rows.size()) {
        throw std::invalid_argument("a measurement needs a value and a row of its covariance for each of its rows");
    }
    MatrixXd errors(n, n), emulated(n, n);
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < n; ++j) {
            errors(i, j) = measurement.covariance[i].at(j);
            emulated(i, j) = emulator.row_covariance(measurement.rows[i], measurement.rows[j]);
        }
    }
    if (Eigen::LLT<MatrixXd>(errors).info() != Eigen::Success) {
        throw std::invalid_argument("the covariance of a measurement is not positive definite");
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(emulated, errors);
    auto parts = std::make_shared<Parts>(Parts{
        emulator, std::move(measurement.rows), Eigen::Map<VectorXd>(measurement.values.data(), n),
        solver.eigenvectors(), solver.eigenvalues().cwiseMax(0.0), measurement.weight, emulator.degrees_of_freedom()});
    parts_ = std::move(parts);
}

double CurveFit::log_likelihood(const Point& point) const {
    const CurveEmulator::Parts::Prediction predicted = parts_->emulator.parts().predict(point);
    VectorXd residual = parts_->values;
    for (Index i = 0; i < residual.size(); ++i) {
        residual[i] -= predicted.mean[parts_->rows[i]];
    }
    const VectorXd along = parts_->axes.transpose() * residual;
    const VectorXd variances = (1 + predicted.variance * parts_->lambda.array()).matrix();
    const double distance = (along.array().square() / variances.array()).sum(), freedom = parts_->freedom;
    const double exponent = (freedom + static_cast<double>(along.size())) * std::log1p(distance / freedom);
    return -0.5 * parts_->weight * (exponent + variances.array().log().sum());
}

} // namespace suffuse::calibration
