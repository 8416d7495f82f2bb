#include "suffuse/figures/line_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace suffuse::figures {
namespace {

TEST(LineFit, FindsALineAndItsScatterInClosedForm) {
    // y = 2 + 3 x, moved up and down by 0.1: residuals of that size around the line of least squares.
    const std::vector<double> x = {0, 1, 2, 3}, y = {2.1, 4.9, 7.9, 11.1};
    const LineFit fit = fit_line(x, y);
    EXPECT_NEAR(fit.slope, 3, 1e-12);
    EXPECT_NEAR(fit.intercept, 2, 1e-12);
    EXPECT_NEAR(fit.scatter, std::sqrt(4 * 0.01 / 2), 1e-12);
    EXPECT_NEAR(fit.half_width, 2.920 * fit.scatter / std::sqrt(5.0), 1e-4);
    EXPECT_TRUE(fit.is_carried());
}

TEST(LineFit, IsNotCarriedByFewPointsNorByOnesThatScatter) {
    EXPECT_FALSE(fit_line(std::vector<double>{0, 1, 2}, std::vector<double>{0, 1, 2}).is_carried());
    EXPECT_TRUE(fit_line(std::vector<double>{0, 1, 2, 3}, std::vector<double>{0, 1, 2, 3}).is_carried());
    EXPECT_FALSE(fit_line(std::vector<double>{0, 1, 2, 3}, std::vector<double>{0, 3, 0, 3}).is_carried());
    EXPECT_FALSE(fit_line(std::vector<double>{1, 1, 1, 1}, std::vector<double>{0, 1, 2, 3}).is_carried());
    EXPECT_FALSE(fit_line({}, {}).is_carried());
    // The interval of a slope that is as wide as it is has its end at 0: s t / sqrt(xx) = slope.
    const auto zigzag = [](double height) { // y = x and a part orthogonal to the line
        const double h = height;
        return fit_line(std::vector<double>{-3, -1, 1, 3}, std::vector<double>{-3 + h, -1 - h, 1 - h, 3 + h});
    };
    const double bound = std::sqrt(20.0) / 2.920 / std::numbers::sqrt2; // scatter is sqrt(4 h²/2)
    EXPECT_TRUE(zigzag(0.999 * bound).is_carried());
    EXPECT_FALSE(zigzag(1.001 * bound).is_carried());
}

} // namespace
} // namespace suffuse::figures
