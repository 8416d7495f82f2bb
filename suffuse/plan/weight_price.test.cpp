#include "suffuse/plan/weight_price.hpp"

#include "suffuse/erosion/ramp.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace suffuse::plan {
namespace {

// Rest and ramp as measured, of 457 fines at a size ratio of 3.5 and 1,940 at 6.5, both moved by upward flow; the last
// of 17,469 at 20.9, moved by level flow, of which half fall through the skeleton without any.
TEST(WeightPrice, CoversTheStepsThatRampsTook) {
    struct Taken {
        std::vector<double> gradients;
        double steps;
        bool sifts = false;
    };

    const std::vector<Taken> all = {
        {erosion::even_gradients(1.2, 8), 513'198},
        {erosion::even_gradients(1.2, 16), 618'258},
        {erosion::even_gradients(1.2, 24), 529'678},
        {erosion::even_gradients(1.2, 12), 342'793},
        {{0.1, 100}, 331'551},
        {{0.3, 3}, 336'345},
        {erosion::even_gradients(1.2, 16), 1'849'094, true}};
    for (const Taken& taken : all) {
        const Range steps = steps_with_weight(levels_of_ramp(taken.gradients), {}, taken.sifts);
        EXPECT_LE(steps.least, taken.steps) << taken.gradients.size();
        EXPECT_GE(steps.most, taken.steps) << taken.gradients.size();
    }
}

TEST(WeightPrice, CountsTheLevelsThatAreInsertedBetweenWideSteps) {
    EXPECT_EQ(levels_of_ramp(erosion::even_gradients(1.2, 24)), 25)
        << "one just below heave, which is taken to be at 1";
    EXPECT_EQ(levels_of_ramp({0.1, 100}), 21) << "19 up to 0.95, one just below heave, and 100";
}

TEST(WeightPrice, FollowsTheHoldAndTheSoftness) {
    const Range usual = steps_with_weight(20, {}, false),
                short_hold = steps_with_weight(20, {.hold_at_most = 20}, false),
                softer = steps_with_weight(20, {.softness = 1e-5}, false);
    EXPECT_LT(short_hold.most, 0.6 * usual.most);
    EXPECT_NEAR(softer.most, 10 * usual.most, 1e-9 * softer.most);
    EXPECT_EQ(flows_with_weight(20, {.hold_at_most = 20}).least, 20);
    EXPECT_GT(flows_with_weight(20, {}).most, flows_with_weight(20, {.hold_at_most = 20}).most);
}

} // namespace
} // namespace suffuse::plan
