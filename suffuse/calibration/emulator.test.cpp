#include "suffuse/calibration/emulator.hpp"

#include "suffuse/base/random.hpp"
#include "suffuse/calibration/emulator_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace suffuse;
using namespace suffuse::calibration;

namespace {

Curve quadratic(const Point& p) {
    const double x = 2 * p[0] - 1, y = 2 * p[1] - 1;
    return {1 + 2 * x - y + 0.5 * x * x + x * y, 3 - x + 4 * y * y};
}

std::vector<Curve> curves_at(const std::vector<Point>& points, const auto& law, double scatter = 0) {
    std::vector<Curve> curves;
    RandomStream noise(5, "noise");
    for (const Point& point : points) {
        curves.push_back(law(point));
        for (double& value : curves.back()) {
            value += scatter * noise.normal();
        }
    }
    return curves;
}

} // namespace

TEST(CurveEmulator, ReproducesAQuadraticLaw) {
    const std::vector<Point> points = design_points(0, 24, 2, 1);
    const CurveEmulator emulator(points, curves_at(points, quadratic));
    for (const Point& point : design_points(100, 20, 2, 1)) {
        const Curve expected = quadratic(point), found = emulator.mean(point);
        for (std::size_t row = 0; row < expected.size(); ++row) {
            EXPECT_NEAR(found[row], expected[row], 5e-4); // of values up to 8: a free trend still counts 1e-4 of 0
        }
    }
}

TEST(CurveEmulator, FindsTheScatterBetweenRuns) {
    constexpr double scatter = 0.3;
    const std::vector<Point> points = design_points(0, 256, 2, 1);
    const CurveEmulator emulator(points, curves_at(points, quadratic, scatter));
    const Point middle = {0.5, 0.5};
    for (int row = 0; row < 2; ++row) { // a variance of 256 values is known to 9 %
        EXPECT_NEAR(emulator.variance(middle) * emulator.row_variance(row), scatter * scatter, 0.02);
        EXPECT_NEAR(emulator.left_out_errors()[row], scatter, 0.04);
    }
    const Eigen::MatrixXd& errors = emulator.parts().standard_errors;
    const double runs = static_cast<double>(errors.rows());
    EXPECT_NEAR(errors.col(0).dot(errors.col(1)) / runs, 0, 0.02) << "rows scatter independently here";
}

TEST(CurveEmulator, LeavesRunsOutAsAFitWithoutThemDoes) {
    const std::vector<Point> points = design_points(0, 20, 1, 4);
    const auto law = [](const Point& p) { return Curve{std::sin(3 * p[0])}; };
    const std::vector<Curve> curves = curves_at(points, law, 0.05);
    double squares = 0;
    for (std::size_t out = 0; out < points.size(); ++out) {
        std::vector<Point> others = points;
        std::vector<Curve> their_curves = curves;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(out));
        their_curves.erase(their_curves.begin() + static_cast<std::ptrdiff_t>(out));
        squares += std::pow(CurveEmulator(others, their_curves).mean(points[out])[0] - curves[out][0], 2);
    }
    const double by_hand = std::sqrt(squares / static_cast<double>(points.size()));
    // The fit without a run may choose another trend, and its curves have another center.
    EXPECT_NEAR(CurveEmulator(points, curves).left_out_errors()[0], by_hand, 0.15 * by_hand);
}

TEST(CurveEmulator, FollowsACurveThatNoQuadraticCan) {
    const auto law = [](const Point& p) { return Curve{std::sin(8 * p[0]) * std::cos(3 * p[1])}; };
    const std::vector<Point> points = design_points(0, 64, 2, 2);
    const CurveEmulator emulator(points, curves_at(points, law));
    double squares = 0;
    for (const Point& point : design_points(500, 50, 2, 2)) {
        squares += std::pow(emulator.mean(point)[0] - law(point)[0], 2);
    }
    EXPECT_LT(std::sqrt(squares / 50), 0.05) << "the law has an amplitude of 1; its best quadratic leaves 0.4";
}

TEST(CurveEmulator, KnowsLessAwayFromItsRuns) {
    std::vector<Point> points = design_points(0, 32, 2, 3);
    for (Point& point : points) {
        point[0] *= 0.5;
    }
    const CurveEmulator emulator(points, curves_at(points, quadratic, 0.1));
    EXPECT_GT(emulator.variance({0.95, 0.5}), 1.5 * emulator.variance({0.25, 0.5}));
    EXPECT_GE(emulator.variance({0.25, 0.5}), 1);
}

TEST(CurveEmulator, NeedsFourRuns) {
    const std::vector<Point> points = design_points(0, 3, 1, 1);
    EXPECT_THROW(CurveEmulator(points, {{1.0}, {2.0}, {3.0}}), std::invalid_argument);
}
