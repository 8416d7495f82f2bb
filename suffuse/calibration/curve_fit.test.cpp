// Fits of emulated curves against closed forms: linear laws whose errors have a known covariance.

#include "suffuse/calibration/curve_fit.hpp"

#include "suffuse/base/random.hpp"
#include "suffuse/calibration/interval.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

using namespace suffuse;
using namespace suffuse::calibration;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int rows = 8, unknowns = 3;

/// Curves of two tests that are linear in three unknowns.
MatrixXd law_of(int test) {
    MatrixXd law(rows, unknowns);
    for (int k = 0; k < rows; ++k) {
        const double x = (k + 1.0) / rows;
        law.row(k) << 1 - std::exp(-4 * x), (test == 0 ? 1 : 0.8) * x * x, std::cos(3 * x + 0.2 * test);
    }
    return law;
}

Curve plus(const VectorXd& curve, const VectorXd& errors) {
    const VectorXd sum = curve + errors;
    return {sum.data(), sum.data() + sum.size()};
}

VectorXd at(const MatrixXd& law, const Point& p) {
    return law * Eigen::Map<const VectorXd>(p.data(), std::ssize(p));
}

MatrixXd matrix_of(const std::vector<Curve>& all) {
    MatrixXd matrix(std::ssize(all), std::ssize(all));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        matrix.row(i) = Eigen::Map<const Eigen::RowVectorXd>(all[i].data(), matrix.cols());
    }
    return matrix;
}

Measurement measured(Curve values, double deviation) {
    Measurement m;
    for (int k = 0; k < std::ssize(values); ++k) {
        m.rows.push_back(k);
    }
    m.deviations.assign(values.size(), deviation);
    m.values = std::move(values);
    return m;
}

std::vector<int> numbers(std::size_t count) {
    std::vector<int> all;
    for (int k = 0; k < static_cast<int>(count); ++k) {
        all.push_back(k + 1);
    }
    return all;
}

/// Errors of two tests: `common` of both, along each curve as `correlated_errors` has it.
struct Scatter {
    MatrixXd factor;

    Scatter(double deviation, double common, double range) {
        const MatrixXd one = matrix_of(correlated_errors(Curve(rows, deviation), {}, range));
        MatrixXd all(2 * rows, 2 * rows);
        all << one, common * one, common * one, one;
        factor = all.llt().matrixL();
    }

    [[nodiscard]] VectorXd draw(RandomStream& stream) const {
        VectorXd normal(2 * rows);
        for (double& value : normal) {
            value = stream.normal();
        }
        return factor * normal;
    }
};

/// Two tests whose runs and measurements scatter alike.
std::vector<FittedTest> scattered_tests(const Scatter& scatter, const Point& truth, int runs, RandomStream& stream) {
    const std::vector<Point> points = design_points(0, runs, unknowns, stream.bits());
    std::vector<Curve> curves[2];
    const VectorXd of_truth = scatter.draw(stream);
    for (const Point& point : points) {
        const VectorXd errors = scatter.draw(stream);
        curves[0].push_back(plus(at(law_of(0), point), errors.head(rows)));
        curves[1].push_back(plus(at(law_of(1), point), errors.tail(rows)));
    }
    std::vector<FittedTest> tests;
    for (int t = 0; t < 2; ++t) {
        const VectorXd errors = of_truth.segment(t * rows, rows);
        tests.push_back(
            {CurveEmulator(points, curves[t]),
             numbers(points.size()),
             {0, 1, 2},
             measured(plus(at(law_of(t), truth), errors), 1e-4)}
        );
    }
    return tests;
}

Posterior posterior_of(const CurveFit& fit, int dimensions, int samples = 1000) {
    return sample_posterior(
        {.dimensions = dimensions,
         .log_likelihood = [&](const Point& p) { return fit.log_likelihood(p); },
         .samples = samples}
    );
}

} // namespace

TEST(CurveFit, OfALinearLawWithKnownErrorsHasTheNormalPosterior) {
    const Point truth = {0.45, 0.55, 0.5};
    constexpr double deviation = 0.08;
    const std::vector<Point> points = design_points(0, 64, unknowns, 2);
    std::vector<FittedTest> tests;
    MatrixXd precision = MatrixXd::Zero(unknowns, unknowns);
    const MatrixXd covariance = matrix_of(correlated_errors(Curve(rows, deviation), {}, range_of_errors));
    for (int t = 0; t < 2; ++t) {
        std::vector<Curve> curves;
        for (const Point& point : points) {
            curves.push_back(plus(at(law_of(t), point), VectorXd::Zero(rows)));
        }
        tests.push_back(
            {CurveEmulator(points, curves),
             numbers(points.size()),
             {0, 1, 2},
             measured(plus(at(law_of(t), truth), VectorXd::Zero(rows)), deviation)}
        );
        precision += law_of(t).transpose() * covariance.inverse() * law_of(t);
    }
    const CurveFit fit(tests);
    EXPECT_EQ(fit.sums(), unknowns) << "three sums hold all that a law of three unknowns says";
    const MatrixXd exact = precision.inverse(), fisher = matrix_of(fit.information(truth));
    const std::vector<Interval> intervals = intervals_of(posterior_of(fit, unknowns, 4000).samples);
    const double freedom = tests[0].emulator.degrees_of_freedom() - unknowns + 1;
    const double wider = std::sqrt(freedom / (freedom - 2)); // Student's t, at most
    for (int k = 0; k < unknowns; ++k) {
        const double sigma = std::sqrt(exact(k, k));
        EXPECT_NEAR(fisher(k, k), precision(k, k), 2e-3 * precision(k, k)); // a free trend still counts 1e-4 of 0
        EXPECT_NEAR(intervals[k].mean, truth[k], 0.08 * sigma);             // 4 standard errors of 3,000
        EXPECT_NEAR(intervals[k].high - intervals[k].low, 2 * 1.645 * sigma * (1 + wider) / 2, 0.06 * 3.29 * sigma);
        EXPECT_NEAR(intervals[k].information, std::log2(std::sqrt(1.0 / 12) / sigma), 0.08);
    }
}

TEST(CurveFit, CoversNineOfTenTruthsWhoseErrorsAreCorrelatedAlongAndBetweenCurves) {
    const Scatter scatter(0.12, 0.8, 20); // as independent ones of the two tests they would cover 0.80
    RandomStream stream(7, "truths");
    constexpr int truths = 200;
    int covered = 0;
    double z_squares = 0;
    for (int k = 0; k < truths; ++k) {
        const Point truth = {stream.uniform(), stream.uniform(), stream.uniform()};
        const CurveFit fit(scattered_tests(scatter, truth, 48, stream));
        const std::vector<Interval> intervals = intervals_of(posterior_of(fit, unknowns, 300).samples);
        for (int d = 0; d < unknowns; ++d) {
            covered += intervals[d].low <= truth[d] && truth[d] <= intervals[d].high ? 1 : 0;
            z_squares += std::pow((intervals[d].mean - truth[d]) / (intervals[d].high - intervals[d].low) * 3.29, 2);
        }
    }
    const double share = covered / (3.0 * truths);
    EXPECT_NEAR(share, 0.9, 0.045); // three standard errors of 200 truths whose three intervals are not independent
    EXPECT_NEAR(std::sqrt(z_squares / (3 * truths)), 1, 0.12) << "errors over deviations";
}

TEST(CurveFit, LeavesOpenWhatReplacesEachOther) {
    const auto law = [](const Point& p) {
        Curve curve;
        for (int k = 0; k < rows; ++k) {
            const double x = (k + 1.0) / rows;
            curve.push_back((p[0] + p[1]) * x + p[2] * x * x);
        }
        return curve;
    };
    const std::vector<Point> points = design_points(0, 48, unknowns, 3);
    std::vector<Curve> curves;
    RandomStream noise(3, "noise");
    for (const Point& point : points) {
        curves.push_back(law(point));
        for (double& value : curves.back()) {
            value += 0.002 * noise.normal();
        }
    }
    // Near a corner of the ranges, these cut the ridge short, and the samples lie in little of each range.
    const CurveFit fit(
        {{CurveEmulator(points, curves), numbers(points.size()), {0, 1, 2}, measured(law({0.15, 0.15, 0.5}), 0.01)}}
    );
    const Posterior posterior = posterior_of(fit, unknowns);
    const std::vector<Interval> intervals = intervals_of(posterior.samples);
    EXPECT_GT(intervals[0].information, identified_from) << "by the samples alone";
    const std::vector<double> of_data =
        information_of_data(posterior.samples, [&](const Point& p) { return fit.information(p); });
    EXPECT_NEAR(of_data[0], 0.5, 0.03) << "one measurement of a sum, shared by two";
    EXPECT_NEAR(of_data[1], 0.5, 0.03);
    EXPECT_GT(of_data[2], identified_from);
}

TEST(CurveFit, CountsATestOfTwiceTheWeightAsTwoOfThem) {
    const std::vector<Point> points = design_points(0, 40, unknowns, 2);
    std::vector<Curve> curves;
    for (const Point& point : points) {
        curves.push_back(plus(at(law_of(0), point), VectorXd::Zero(rows)));
    }
    const Point truth = {0.5, 0.5, 0.5};
    FittedTest test{
        CurveEmulator(points, curves),
        numbers(points.size()),
        {0, 1, 2},
        measured(plus(at(law_of(0), truth), VectorXd::Zero(rows)), 0.1)};
    const CurveFit two({test, test});
    test.measured.weight = 2;
    const CurveFit weighted({test});
    const MatrixXd a = matrix_of(two.information(truth)), b = matrix_of(weighted.information(truth));
    EXPECT_LT((a - b).norm(), 1e-3 * a.norm());
}

TEST(CurveFit, KnowsATestByItsOwnUnknownsAlone) {
    const std::vector<Point> points = design_points(0, 40, 1, 2);
    std::vector<Curve> curves;
    for (const Point& p : points) {
        curves.push_back({p[0], 2 * p[0]});
    }
    const CurveFit fit({{CurveEmulator(points, curves), numbers(points.size()), {1}, measured({0.3, 0.6}, 0.1)}});
    EXPECT_EQ(fit.log_likelihood({0.1, 0.4}), fit.log_likelihood({0.9, 0.4}));
    EXPECT_GT(fit.log_likelihood({0.1, 0.3}), fit.log_likelihood({0.1, 0.4}));
    EXPECT_EQ(fit.information({0.5, 0.5})[0][0], 0);
}

TEST(CurveFit, RefusesErrorsOfNothing) {
    const std::vector<Point> points = design_points(0, 8, 1, 2);
    const std::vector<Curve> curves(8, Curve{1.0});
    const CurveEmulator emulator(points, curves);
    EXPECT_THROW(CurveFit({{emulator, numbers(8), {0}, measured({1.0}, 0)}}), std::invalid_argument);
    EXPECT_THROW(CurveFit({{emulator, numbers(7), {0}, measured({1.0}, 0.1)}}), std::invalid_argument);
    EXPECT_THROW(CurveFit({}), std::invalid_argument);
}

TEST(CurveFit, HasErrorsThatDeclineWithinAQuantityAndAreIndependentBetweenTwo) {
    const std::vector<Curve> errors = correlated_errors({1, 2, 3}, {2}, 4);
    EXPECT_NEAR(errors[0][1], 2 * std::exp(-0.25), 1e-12);
    EXPECT_EQ(errors[0][2], 0);
    EXPECT_EQ(errors[2][2], 9);
}
