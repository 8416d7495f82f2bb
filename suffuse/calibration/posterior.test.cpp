// Samples of posteriors against those that are known in closed form.

#include "suffuse/calibration/posterior.hpp"

#include "suffuse/calibration/feasibility.hpp"
#include "suffuse/calibration/interval.hpp"
#include "suffuse/calibration/next_designs.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

using namespace suffuse::calibration;

namespace {

/// A linear law of three unknowns, measured with normal errors: the posterior is normal, far from the ends of the cube.
struct LinearProblem {
    Eigen::MatrixXd law = (Eigen::MatrixXd(4, 3) << 1, 2, 0, 0, 1, -1, 2, 0, 1, 1, 1, 1).finished();
    Eigen::Vector3d truth = {0.5, 0.45, 0.55};
    double error = 0.06;

    [[nodiscard]] double log_likelihood(const Point& p) const {
        const Eigen::Vector3d x(p[0], p[1], p[2]);
        return -0.5 * (law * (x - truth)).squaredNorm() / (error * error);
    }

    [[nodiscard]] Eigen::Matrix3d covariance() const { return error * error * (law.transpose() * law).inverse(); }
};

PosteriorProblem problem_of(const LinearProblem& linear) {
    return {.dimensions = 3, .log_likelihood = [&](const Point& p) { return linear.log_likelihood(p); }};
}

} // namespace

TEST(Posterior, OfALinearLawWithNormalErrorsIsTheNormalOne) {
    const LinearProblem linear;
    PosteriorProblem problem = problem_of(linear);
    problem.samples = 4000;
    const Posterior found = sample_posterior(problem);
    const Eigen::Matrix3d exact = linear.covariance();
    const std::vector<Interval> intervals = intervals_of(found.samples);
    const std::vector<std::vector<double>> correlations = correlations_of(found.samples);
    EXPECT_GT(found.effective, 3000);
    for (int a = 0; a < 3; ++a) {
        const double deviation = std::sqrt(exact(a, a));
        EXPECT_NEAR(intervals[a].mean, linear.truth[a], 0.08 * deviation); // 4 standard errors of 3,000
        EXPECT_NEAR(intervals[a].high - intervals[a].low, 2 * 1.645 * deviation, 0.06 * 2 * 1.645 * deviation);
        EXPECT_EQ(intervals[a].bound, Bound::None);
        for (int b = 0; b < 3; ++b) {
            EXPECT_NEAR(correlations[a][b], exact(a, b) / std::sqrt(exact(a, a) * exact(b, b)), 0.06);
        }
    }
}

TEST(Posterior, WithoutDataIsThePrior) {
    const Posterior found = sample_posterior({.dimensions = 2, .log_likelihood = [](const Point&) { return 0.0; }});
    for (const Interval& interval : intervals_of(found.samples)) {
        EXPECT_NEAR(interval.mean, 0.5, 0.03);
        EXPECT_NEAR(interval.width, 1, 0.03);
        EXPECT_NEAR(interval.information, 0, 0.03);
        EXPECT_FALSE(interval.is_identified());
        EXPECT_EQ(interval.bound, Bound::None);
    }
}

TEST(Posterior, FindsBothOfTwoPeaks) {
    const auto peaks = [](const Point& p) {
        const double far = p[0] - 0.2, near = p[0] - 0.8, s = 2 * 0.03 * 0.03;
        return std::log(std::exp(-far * far / s) + std::exp(-near * near / s) + 1e-300);
    };
    const Posterior found = sample_posterior({.dimensions = 1, .log_likelihood = peaks});
    EXPECT_NEAR(intervals_of(found.samples)[0].mean, 0.5, 0.06) << "half of the samples at each peak";
}

TEST(Posterior, KeepsToWhatIsAllowedAndNamesTheBound) {
    PosteriorProblem problem{.dimensions = 2, .log_likelihood = [](const Point& p) { return 40 * p[0]; }};
    problem.is_allowed = [](const Point& p) { return p[1] <= 0.5 * p[0]; };
    const Posterior found = sample_posterior(problem);
    for (const Point& sample : found.samples) {
        EXPECT_LE(sample[1], 0.5 * sample[0]);
    }
    const std::vector<Interval> intervals = intervals_of(found.samples);
    EXPECT_EQ(intervals[0].bound, Bound::High);
    EXPECT_NEAR(intervals[0].mean, 1 - 1.0 / 40, 0.004) << "the mean of an exponential law of rate 40";
    EXPECT_EQ(intervals[1].bound, Bound::None);
}

TEST(Posterior, FollowsFromItsSeedToTheBit) {
    const LinearProblem linear;
    PosteriorProblem problem = problem_of(linear);
    problem.samples = 200;
    const std::vector<Point> first = sample_posterior(problem).samples;
    EXPECT_EQ(first, sample_posterior(problem).samples);
    problem.seed = 2;
    EXPECT_NE(first, sample_posterior(problem).samples);
}

TEST(Posterior, RefusesConstraintsThatNothingMeets) {
    PosteriorProblem problem{.dimensions = 1, .log_likelihood = [](const Point&) { return 0.0; }};
    problem.is_allowed = [](const Point&) { return false; };
    problem.samples = 10;
    EXPECT_THROW(sample_posterior(problem), std::runtime_error);
}

TEST(Feasibility, FallsWhereRunsFailed) {
    const Feasibility feasibility({{0.2, 0.2}, {0.2, 0.8}}, {{0.9, 0.9}, {0.8, 0.9}});
    EXPECT_GT(feasibility.chance({0.2, 0.3}), 0.95);
    EXPECT_EQ(feasibility.chance({0.85, 0.9}), 0.2);
    EXPECT_EQ(Feasibility({{0.2}}, {}).chance({0.9}), 1);
}

TEST(NextDesigns, GoToWhereTheEmulatorIsUnsureAndKeepApart) {
    std::vector<Point> candidates;
    for (int k = 0; k <= 100; ++k) {
        candidates.push_back({k / 100.0});
    }
    const std::vector<Point> picked =
        next_designs(candidates, 3, {{0.0}}, [](const Point& p) { return p[0] > 0.495 ? 1.0 : 0.1; });
    ASSERT_EQ(picked.size(), 3U);
    EXPECT_EQ(picked[0][0], 1.0) << "the farthest from what is known";
    EXPECT_NEAR(picked[1][0], 0.5, 1e-12) << "the farthest from both";
    EXPECT_NEAR(picked[2][0], 0.75, 1e-12);
}
