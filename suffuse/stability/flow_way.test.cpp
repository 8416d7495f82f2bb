#include "suffuse/stability/flow_way.hpp"

#include <gtest/gtest.h>

namespace suffuse::stability {
namespace {

TEST(FlowWay, IsAWordOrAnAngle) {
    EXPECT_EQ(flow_way_of("up"), upward);
    EXPECT_EQ(flow_way_of("level"), level_flow);
    EXPECT_EQ(flow_way_of("down"), downward);
    EXPECT_EQ(flow_way_of("90deg"), upward);
    EXPECT_EQ(flow_way_of("30 deg"), FlowWay{30});
    EXPECT_EQ(flow_way_of("-12.5"), FlowWay{-12.5});
    for (const char* word : {"", "deg", "upward", "91", "30 rad", "1e400", "nan"}) {
        EXPECT_FALSE(flow_way_of(word)) << word;
    }
}

TEST(FlowWay, HasANameThatIsReadAgain) {
    for (const FlowWay way : {upward, level_flow, downward, FlowWay{30}, FlowWay{-12.5}}) {
        EXPECT_EQ(flow_way_of(name_of(way)), way);
    }
    EXPECT_EQ(kind_of(FlowWay{30}), "rising");
    EXPECT_EQ(kind_of(FlowWay{-30}), "sinking");
}

TEST(FlowWay, LiftsByTheSineOfItsAngle) {
    EXPECT_EQ(lift_of(upward), 1);
    EXPECT_EQ(lift_of(level_flow), 0);
    EXPECT_NEAR(lift_of({30}), 0.5, 1e-15);
    EXPECT_NEAR(lift_of({-30}), -0.5, 1e-15);
}

} // namespace
} // namespace suffuse::stability
