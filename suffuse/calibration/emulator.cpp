#include "suffuse/calibration/emulator_parts.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace suffuse::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double trend_variance = 1e4;    // of each coefficient / scatter between runs: it is free to be anything
constexpr double judged_variation = 0.99; // of the curves is in the components by which assumptions are compared
constexpr int runs_a_component = 6;       // at least
constexpr int chosen_numbers = 2;         // share and correlation length, by which the errors became the likeliest

VectorXd basis_of(const VectorXd& z, int degree) {
    std::vector<double> terms = {1.0};
    for (Index i = 0; degree > 0 && i < z.size(); ++i) {
        terms.push_back(z[i]);
    }
    for (Index i = 0; degree > 1 && i < z.size(); ++i) {
        for (Index j = i; j < z.size(); ++j) {
            terms.push_back(z[i] * z[j]);
        }
    }
    return Eigen::Map<const VectorXd>(terms.data(), static_cast<Index>(terms.size()));
}

double covariance(const VectorXd& a, const VectorXd& b, const Smoothness& s) {
    const double trend = trend_variance * basis_of(a, s.degree).dot(basis_of(b, s.degree));
    return trend + s.share * std::exp(-0.5 * (a - b).squaredNorm() / (s.correlation * s.correlation));
}

struct Trial {
    Eigen::LLT<MatrixXd> factor;
    VectorXd variances; ///< of each run when it is left out
    MatrixXd weights, errors;
    double score = std::numeric_limits<double>::infinity(); ///< -2 log likelihood of the errors
};

/// Weights of the rows that give the principal components of the curves, each row over its deviation. Rows say the same
/// thing again and again; by them all, chance would look like a law.
MatrixXd components_of(const MatrixXd& curves) {
    const VectorXd deviations = (curves.colwise().squaredNorm() / static_cast<double>(curves.rows())).cwiseSqrt();
    const VectorXd scale = (deviations.array() > 0).select(deviations.array().inverse(), 0).matrix();
    const MatrixXd scaled = curves * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(scaled.transpose() * scaled);
    const VectorXd& variation = solver.eigenvalues(); // rising
    const Index most = std::clamp(curves.rows() / runs_a_component, Index{1}, variation.size());
    Index count = 1;
    while (count < most && variation.tail(count).sum() < judged_variation * variation.sum()) {
        ++count;
    }
    return scale.asDiagonal() * solver.eigenvectors().rightCols(count);
}

/// Errors of leaving one out in closed form [Rasmussen and Williams 2006, eq. 5.12].
Trial tried(const MatrixXd& points, const MatrixXd& curves, const MatrixXd& components, const Smoothness& s) {
    const Index n = points.rows();
    MatrixXd all(n, n);
    for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j <= i; ++j) {
            all(i, j) = all(j, i) =
                covariance(points.row(i).transpose(), points.row(j).transpose(), s) + (i == j ? 1.0 : 0.0);
        }
    }
    Trial trial;
    trial.factor.compute(all);
    if (trial.factor.info() != Eigen::Success) {
        return trial;
    }
    trial.weights = trial.factor.solve(curves);
    trial.variances = trial.factor.solve(MatrixXd::Identity(n, n)).diagonal().cwiseInverse();
    trial.errors = trial.variances.asDiagonal() * trial.weights;
    const MatrixXd judged = trial.variances.cwiseSqrt().cwiseInverse().asDiagonal() * trial.errors * components;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> spread(judged.transpose() * judged / static_cast<double>(n));
    const double least = std::numeric_limits<double>::min();
    trial.score = static_cast<double>(n) * spread.eigenvalues().cwiseMax(least).array().log().sum() +
                  static_cast<double>(components.cols()) * trial.variances.array().log().sum();
    return trial;
}

Index terms_of(Index dimensions, int degree) {
    const Index d = dimensions;
    return degree == 0 ? 1 : degree == 1 ? 1 + d : 1 + d + d * (d + 1) / 2;
}

/// The likeliest of a few, by the errors of leaving one out with their covariance over the components; a trend needs
/// more runs than it has terms.
Smoothness choose(const MatrixXd& points, const MatrixXd& curves, Trial& best) {
    const MatrixXd components = components_of(curves);
    Smoothness chosen;
    for (const int degree : {0, 1, 2}) {
        if (degree > 0 && points.rows() < terms_of(points.cols(), degree) + 3) {
            continue;
        }
        for (const double share : {0.0, 1.0, 10.0, 100.0, 1000.0}) {
            for (const double correlation : {0.7, 1.4, 2.8}) {
                const Smoothness s{degree, share, correlation};
                if (Trial trial = tried(points, curves, components, s); trial.score < best.score) {
                    best = std::move(trial);
                    chosen = s;
                }
                if (share == 0) {
                    break; // no process, whatever its length
                }
            }
        }
    }
    return chosen;
}

} // namespace

VectorXd inner_point(const Point& point) {
    VectorXd z(static_cast<Index>(point.size()));
    for (Index i = 0; i < z.size(); ++i) {
        z[i] = 2 * point[i] - 1;
    }
    return z;
}

CurveEmulator::Parts::Prediction CurveEmulator::Parts::predict(const Point& point) const {
    const VectorXd z = inner_point(point), own = basis_of(z, smoothness.degree);
    Prediction found{center + trend.transpose() * own};
    VectorXd shared = trend_variance * (basis * own);
    if (smoothness.share > 0) {
        const double scale = -0.5 / (smoothness.correlation * smoothness.correlation);
        const VectorXd process =
            smoothness.share *
            (scale * (points.rowwise() - z.transpose()).rowwise().squaredNorm()).array().exp().matrix();
        found.mean += weights.transpose() * process;
        shared += process;
    }
    const double before = covariance(z, z, smoothness);
    found.variance += std::max(0.0, before - factor.matrixL().solve(shared).squaredNorm());
    return found;
}

CurveEmulator::Parts CurveEmulator::Parts::summed(const std::vector<int>& rows, const MatrixXd& sums) const {
    MatrixXd all = MatrixXd::Zero(center.size(), sums.cols());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        all.row(rows[k]) = sums.row(static_cast<Index>(k));
    }
    Parts of_sums = *this;
    of_sums.center = all.transpose() * center;
    of_sums.weights = weights * all;
    of_sums.trend = trend * all;
    of_sums.fitted = fitted * all;
    of_sums.left_out = left_out * all;
    of_sums.standard_errors = standard_errors * all;
    return of_sums;
}

CurveEmulator::CurveEmulator(const std::vector<Point>& points, const std::vector<Curve>& curves) {
    if (points.size() < 4 || points.size() != curves.size()) {
        throw std::invalid_argument("an emulator needs four runs, with a curve each");
    }
    auto parts = std::make_shared<Parts>();
    const auto n = static_cast<Index>(points.size()), rows = static_cast<Index>(curves.front().size());
    parts->points.resize(n, static_cast<Index>(points.front().size()));
    MatrixXd values(n, rows);
    for (Index i = 0; i < n; ++i) {
        parts->points.row(i) = inner_point(points[i]).transpose();
        values.row(i) = Eigen::Map<const VectorXd>(curves[i].data(), rows).transpose();
    }
    parts->center = values.colwise().mean().transpose();
    values.rowwise() -= parts->center.transpose();
    Trial best;
    parts->smoothness = choose(parts->points, values, best);
    const double fitted_away = std::sqrt(static_cast<double>(n) / static_cast<double>(n - chosen_numbers));
    parts->standard_errors = fitted_away * best.variances.cwiseSqrt().cwiseInverse().asDiagonal() * best.errors;
    parts->fitted = values - best.weights; // the scatter between runs has variance 1
    parts->weights = std::move(best.weights);
    parts->basis.resize(n, terms_of(parts->points.cols(), parts->smoothness.degree));
    for (Index i = 0; i < n; ++i) {
        parts->basis.row(i) = basis_of(parts->points.row(i).transpose(), parts->smoothness.degree).transpose();
    }
    parts->trend = trend_variance * parts->basis.transpose() * parts->weights;
    parts->factor = std::move(best.factor);
    parts->left_out = std::move(best.errors);
    parts_ = std::move(parts);
}

Curve CurveEmulator::mean(const Point& point) const {
    const VectorXd curve = parts_->predict(point).mean;
    return {curve.data(), curve.data() + curve.size()};
}

double CurveEmulator::variance(const Point& point) const {
    return parts_->predict(point).variance;
}

double CurveEmulator::row_variance(int row) const {
    return parts_->standard_errors.col(row).squaredNorm() / static_cast<double>(parts_->standard_errors.rows());
}

Curve CurveEmulator::left_out_errors() const {
    const MatrixXd& errors = parts_->left_out;
    const VectorXd rms = (errors.colwise().squaredNorm() / static_cast<double>(errors.rows())).cwiseSqrt().transpose();
    return {rms.data(), rms.data() + rms.size()};
}

int CurveEmulator::rows() const {
    return static_cast<int>(parts_->center.size());
}

double CurveEmulator::degrees_of_freedom() const {
    return std::max(4.0, static_cast<double>(parts_->basis.rows() - parts_->basis.cols() - chosen_numbers));
}

} // namespace suffuse::calibration
