// Where the next samples are sought, and whether any are needed.

#include "suffuse/calibration/next_designs.hpp"

#include <gtest/gtest.h>

namespace suffuse::calibration {

TEST(NextDesigns, AreWhereTheEmulatorsKnowLeastAndNothingIsNear) {
    const std::vector<Point> candidates{{0.1}, {0.12}, {0.5}, {0.9}};
    const auto unsure_above_half = [](const Point& point) { return point[0] > 0.4 ? 1.0 : 0.1; };
    const std::vector<Point> picked = next_designs(candidates, 3, {{0.45}}, unsure_above_half);
    EXPECT_EQ(picked, (std::vector<Point>{{0.9}, {0.5}, {0.1}}));
}

TEST(NextDesigns, AreSoughtUntilTheIntervalsStayAsTheyAre) {
    EXPECT_FALSE(has_settled(0.4, 0.3)) << "they still shrink";
    EXPECT_TRUE(has_settled(0.4, 0.39));
    EXPECT_TRUE(has_settled(0.4, 0.41));
    EXPECT_FALSE(has_settled(0.3, 0.4)) << "the rounds before knew too little";
}

} // namespace suffuse::calibration
