#include "suffuse/calibration/sobol.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace suffuse::calibration;

TEST(Sobol, GivesTheFirstPointsThatJoeAndKuoPublish) {
    const std::vector<Point> published = {
        {0, 0, 0},
        {0.5, 0.5, 0.5},
        {0.75, 0.25, 0.25},
        {0.25, 0.75, 0.75},
        {0.375, 0.375, 0.625},
        {0.875, 0.875, 0.125},
        {0.625, 0.125, 0.875},
        {0.125, 0.625, 0.375},
        {0.1875, 0.3125, 0.9375},
        {0.6875, 0.8125, 0.4375}};
    for (std::size_t k = 0; k < published.size(); ++k) {
        EXPECT_EQ(sobol_point(static_cast<std::uint32_t>(k), 3), published[k]) << "point " << k;
    }
}

TEST(Sobol, PutsOnePointIntoEachSliceOfEveryAxis) {
    constexpr int count = 64;
    for (const std::uint32_t first : {0U, 64U, 640U}) {
        const std::vector<Point> points = design_points(first, count, most_dimensions, 7);
        for (int d = 0; d < most_dimensions; ++d) {
            std::set<int> slices;
            for (const Point& point : points) {
                slices.insert(static_cast<int>(point[d] * count));
            }
            EXPECT_EQ(slices.size(), count) << "axis " << d << " from point " << first;
        }
    }
}

TEST(Sobol, FillsEveryPairOfTheFirstTwoAxesEvenly) {
    std::set<std::pair<int, int>> boxes; // (0, 6, 2)-net: one in each box of 1/8 by 1/8
    for (const Point& point : design_points(0, 64, 2, 3)) {
        boxes.insert({static_cast<int>(point[0] * 8), static_cast<int>(point[1] * 8)});
    }
    EXPECT_EQ(boxes.size(), 64U);
}

TEST(Sobol, IntegratesASmoothFunctionFarBetterThanRandomPoints) {
    constexpr int dimensions = 8, count = 4096;
    double sum = 0; // of the product of 1 + (x - 1/2) / 2, whose mean is 1
    for (const Point& point : design_points(0, count, dimensions, 11)) {
        double product = 1;
        for (const double x : point) {
            product *= 1 + (x - 0.5) / 2;
        }
        sum += product;
    }
    const double deviation = std::sqrt(std::pow(1 + 1.0 / 48, dimensions) - 1); // of one random point
    EXPECT_NEAR(sum / count, 1, 0.1 * deviation / std::sqrt(count));
}

TEST(Sobol, FollowsFromItsSeed) {
    EXPECT_EQ(design_points(5, 3, 4, 1), design_points(5, 3, 4, 1));
    EXPECT_NE(design_points(5, 3, 4, 1), design_points(5, 3, 4, 2));
    EXPECT_EQ(design_points(0, 9, 4, 1)[7], design_points(7, 1, 4, 1)[0]);
}
