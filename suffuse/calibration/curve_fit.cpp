#include "suffuse/calibration/curve_fit.hpp"

#include "suffuse/calibration/emulator_parts.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace suffuse::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_signal = 1;        // variance over the design / variance of errors: half a bit
constexpr double freedom_a_sum = 2;       // left-out errors that the covariance of the sums needs for each of them
constexpr double longest = 12;            // range of the errors that the weights suppose, in rows
constexpr double step_of_gradient = 0.01; // of the cube's side

MatrixXd columns_of(const MatrixXd& all, const std::vector<int>& rows) {
    MatrixXd chosen(all.rows(), static_cast<Index>(rows.size()));
    for (Index k = 0; k < chosen.cols(); ++k) {
        chosen.col(k) = all.col(rows[static_cast<std::size_t>(k)]);
    }
    return chosen;
}

MatrixXd matrix_of(const std::vector<Curve>& rows) {
    MatrixXd matrix(static_cast<Index>(rows.size()), static_cast<Index>(rows.size()));
    for (Index i = 0; i < matrix.rows(); ++i) {
        for (Index j = 0; j < matrix.cols(); ++j) {
            matrix(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        }
    }
    return matrix;
}

/// Over which the correlation of neighbors' errors says that they decline.
double range_of(const MatrixXd& errors, const std::vector<int>& begins) {
    double product = 0, square = 0;
    for (Index k = 0; k + 1 < errors.cols(); ++k) {
        if (std::ranges::find(begins, static_cast<int>(k + 1)) == begins.end()) {
            const double norm = errors.col(k).norm() * errors.col(k + 1).norm();
            product += norm > 0 ? errors.col(k).dot(errors.col(k + 1)) / norm : 0;
            square += 1;
        }
    }
    const double neighbors = square > 0 ? std::clamp(product / square, 0.1, std::exp(-1 / longest)) : 0.1;
    return -1 / std::log(neighbors);
}

/// One test's part of the columns of `Table`.
struct Block {
    Index begin = 0, size = 0;
    double runs = 0;
};

/// What all runs say of the measured rows of all tests, side by side: a row a run, 0 where it failed.
struct Table {
    MatrixXd fitted, errors; ///< emulated curves minus their mean; errors of leaving one out at variance 1
    MatrixXd supposed;       ///< a simple model of all errors, from which the weights of the sums follow
    std::vector<Block> blocks;
};

Table table_of(const std::vector<FittedTest>& tests) {
    std::set<int> numbers;
    Index columns = 0;
    for (const FittedTest& test : tests) {
        numbers.insert(test.runs.begin(), test.runs.end());
        columns += static_cast<Index>(test.measured.rows.size());
    }
    const std::vector<int> runs(numbers.begin(), numbers.end());
    Table table{MatrixXd::Zero(std::ssize(runs), columns), {}, MatrixXd::Zero(columns, columns), {}};
    table.errors = table.fitted;
    Index begin = 0;
    for (const FittedTest& test : tests) {
        const CurveEmulator::Parts& parts = test.emulator.parts();
        const Index size = std::ssize(test.measured.rows);
        const MatrixXd fitted = columns_of(parts.fitted, test.measured.rows);
        const MatrixXd errors = columns_of(parts.standard_errors, test.measured.rows);
        for (std::size_t k = 0; k < test.runs.size(); ++k) {
            const Index row = std::ranges::lower_bound(runs, test.runs[k]) - runs.begin();
            table.fitted.row(row).segment(begin, size) = fitted.row(static_cast<Index>(k));
            table.errors.row(row).segment(begin, size) = errors.row(static_cast<Index>(k));
        }
        const VectorXd rms = (errors.colwise().squaredNorm() / static_cast<double>(errors.rows())).cwiseSqrt();
        const Measurement& measured = test.measured;
        const Curve emulated(rms.data(), rms.data() + size);
        table.supposed.block(begin, begin, size, size) =
            (matrix_of(correlated_errors(measured.deviations, measured.begins, range_of_errors)) +
             matrix_of(correlated_errors(emulated, measured.begins, range_of(errors, measured.begins)))) /
            measured.weight;
        table.blocks.push_back({begin, size, static_cast<double>(errors.rows())});
        begin += size;
    }
    return table;
}

double freedom_of(const std::vector<FittedTest>& tests) {
    double least = tests.front().emulator.degrees_of_freedom();
    for (const FittedTest& test : tests) {
        least = std::min(least, test.emulator.degrees_of_freedom());
    }
    return least;
}

/// Columns: weights of the rows whose sums tell parameters from the supposed errors, the best first.
MatrixXd weights_of(const Table& table, double freedom) {
    const MatrixXd signal = table.fitted.transpose() * table.fitted / static_cast<double>(table.fitted.rows());
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(signal, table.supposed);
    const auto most = std::clamp(static_cast<Index>(freedom / freedom_a_sum), Index{1}, signal.rows());
    const Index strong = (solver.eigenvalues().array() > least_signal).count();
    return solver.eigenvectors().rightCols(std::clamp(strong, Index{1}, most)).rowwise().reverse();
}

void check(const std::vector<FittedTest>& tests) {
    if (tests.empty()) {
        throw std::invalid_argument("a fit needs a test");
    }
    for (const FittedTest& test : tests) {
        const Measurement& m = test.measured;
        if (m.rows.empty() || m.values.size() != m.rows.size() || m.deviations.size() != m.rows.size() ||
            std::ssize(test.runs) != test.emulator.parts().standard_errors.rows()) {
            throw std::invalid_argument("a measurement needs a value and a deviation for each row, a test all its runs"
            );
        }
        if (std::ranges::any_of(m.deviations, [](double deviation) { return !(deviation > 0); })) {
            throw std::invalid_argument("the deviations of a measurement must be above 0");
        }
    }
}

} // namespace

struct CurveFit::Parts {
    struct Test {
        CurveEmulator::Parts emulator; ///< of the sums
        std::vector<int> unknowns;
    };

    std::vector<Test> tests;
    VectorXd values;                           ///< the sums of what was measured
    MatrixXd own;                              ///< covariance of the measurements' errors
    std::vector<std::vector<MatrixXd>> shared; ///< that of the runs left out, of each pair of tests at variance 1
    double freedom = 1;                        ///< of Student's t

    struct Residual {
        VectorXd sums;
        Eigen::LLT<MatrixXd> covariance;
    };

    [[nodiscard]] Residual residual(const Point& point) const {
        Residual found{values, {}};
        MatrixXd covariance = own;
        VectorXd scales(std::ssize(tests));
        for (std::size_t t = 0; t < tests.size(); ++t) {
            const CurveEmulator::Parts::Prediction one = tests[t].emulator.predict(own_point(tests[t], point));
            found.sums -= one.mean;
            scales[static_cast<Index>(t)] = std::sqrt(one.variance);
        }
        for (std::size_t a = 0; a < tests.size(); ++a) {
            for (std::size_t b = 0; b < tests.size(); ++b) {
                covariance += scales[static_cast<Index>(a)] * scales[static_cast<Index>(b)] * shared[a][b];
            }
        }
        found.covariance.compute(covariance);
        return found;
    }

    static Point own_point(const Test& test, const Point& point) {
        Point chosen;
        chosen.reserve(test.unknowns.size());
        for (const int k : test.unknowns) {
            chosen.push_back(point[static_cast<std::size_t>(k)]);
        }
        return chosen;
    }
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

CurveFit::CurveFit(const std::vector<FittedTest>& tests) {
    check(tests);
    const Table table = table_of(tests);
    const double freedom = freedom_of(tests);
    const MatrixXd weights = weights_of(table, freedom);
    const Index sums = weights.cols();
    auto parts = std::make_shared<Parts>();
    parts->values = VectorXd::Zero(sums);
    parts->own = MatrixXd::Zero(sums, sums);
    parts->freedom = freedom - static_cast<double>(sums) + 1;
    parts->shared.assign(tests.size(), std::vector<MatrixXd>(tests.size()));
    for (std::size_t a = 0; a < tests.size(); ++a) {
        const Measurement& measured = tests[a].measured;
        const Block& block = table.blocks[a];
        const MatrixXd here = weights.middleRows(block.begin, block.size);
        parts->values += here.transpose() * Eigen::Map<const VectorXd>(measured.values.data(), block.size);
        parts->own += here.transpose() *
                      matrix_of(correlated_errors(measured.deviations, measured.begins, range_of_errors)) * here /
                      measured.weight;
        parts->tests.push_back({tests[a].emulator.parts().summed(measured.rows, here), tests[a].unknowns});
        for (std::size_t b = 0; b < tests.size(); ++b) {
            const Block& other = table.blocks[b];
            const double count = std::sqrt(block.runs * other.runs * measured.weight * tests[b].measured.weight);
            parts->shared[a][b] = freedom / parts->freedom / count * here.transpose() *
                                  table.errors.middleCols(block.begin, block.size).transpose() *
                                  table.errors.middleCols(other.begin, other.size) *
                                  weights.middleRows(other.begin, other.size);
        }
    }
    parts_ = std::move(parts);
}

double CurveFit::log_likelihood(const Point& point) const {
    const Parts::Residual residual = parts_->residual(point);
    const double distance = residual.covariance.matrixL().solve(residual.sums).squaredNorm();
    const double logarithm = 2 * residual.covariance.matrixLLT().diagonal().array().log().sum();
    const double exponent = parts_->freedom + static_cast<double>(residual.sums.size());
    return -0.5 * (exponent * std::log1p(distance / parts_->freedom) + logarithm);
}

std::vector<Curve> CurveFit::information(const Point& point) const {
    const auto n = static_cast<Index>(point.size());
    MatrixXd gradient(parts_->values.size(), n);
    for (Index k = 0; k < n; ++k) {
        Point above = point, below = point;
        above[static_cast<std::size_t>(k)] += step_of_gradient;
        below[static_cast<std::size_t>(k)] -= step_of_gradient;
        gradient.col(k) = (parts_->residual(below).sums - parts_->residual(above).sums) / (2 * step_of_gradient);
    }
    const MatrixXd scaled = parts_->residual(point).covariance.matrixL().solve(gradient);
    const MatrixXd fisher = scaled.transpose() * scaled;
    std::vector<Curve> rows;
    rows.reserve(point.size());
    for (Index k = 0; k < n; ++k) {
        const VectorXd row = fisher.row(k).transpose();
        rows.emplace_back(row.data(), row.data() + n);
    }
    return rows;
}

int CurveFit::sums() const {
    return static_cast<int>(parts_->values.size());
}

} // namespace suffuse::calibration
