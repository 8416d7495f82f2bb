#include "suffuse/erosion/loop.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>

namespace suffuse::erosion {
namespace {

TEST(ErosionLoop, OfFinesAloneIsRefusedForThereIsNoSkeleton) {
    dem::World world = test::reference_packing("packing500");
    std::fill(world.grains.fine.begin(), world.grains.fine.end(), std::uint8_t{1});
    const std::vector<Vec3> before = world.grains.position;
    ErosionResult result;
    PassUnderWay now;
    try {
        erode_once(world, {}, {}, result, now);
        FAIL() << "it was eroded";
    } catch (const StateError& error) {
        EXPECT_NE(std::string(error.what()).find("all grains are fines"), std::string::npos) << error.what();
    }
    EXPECT_EQ(world.grains.position, before);
    EXPECT_TRUE(result.passes.empty());
}

TEST(ErosionLoop, IsExhaustedByOnePassThatTakesNothingOrByThreeWhereGrainsTravel) {
    const auto pass = [](std::int64_t detachable, std::int64_t removed) {
        PassResult result;
        result.pass = 3;
        result.detachable = detachable, result.removed = removed;
        return result;
    };
    ErosionResult one, two, late;
    one.passes = {pass(9, 0)};
    two.passes = {pass(9, 4), pass(9, 0), pass(9, 0)};
    late.passes = {pass(9, 0), pass(9, 4), pass(9, 0)};
    ErodeSpec spec;
    EXPECT_TRUE(is_exhausted(spec, {}, pass(9, 0)));
    EXPECT_FALSE(is_exhausted(spec, two, pass(9, 1)));
    spec.passes_constriction = ConstrictionSize::FlowPath;
    EXPECT_FALSE(is_exhausted(spec, one, pass(9, 0))) << "the second in a row";
    EXPECT_TRUE(is_exhausted(spec, two, pass(9, 0))) << "the third in a row";
    EXPECT_FALSE(is_exhausted(spec, late, pass(9, 0)));
    EXPECT_TRUE(is_exhausted(spec, one, pass(0, 0))) << "nothing is on its way";
    spec.later_passes.resize(3);
    EXPECT_FALSE(is_exhausted(spec, two, pass(9, 0))) << "the next pass asks something else";
}

TEST(ErosionLoop, ACustomRuleIsRefusedWhereNoProbeUsesOne) {
    const OwnRule rule{"mine", "", [](const dem::World& /*world*/, const ProbeResult& probe) {
                           return std::vector<std::uint8_t>(probe.id.size(), 1);
                       }};
    ErodeSpec forced, weighed;
    forced.forced.emplace();
    weighed.probe.gravity.emplace();
    EXPECT_THROW(check_own_rule(forced, rule), UsageError);
    EXPECT_THROW(check_own_rule(weighed, rule), UsageError);
    EXPECT_NO_THROW(check_own_rule(ErodeSpec{}, rule));
}

} // namespace
} // namespace suffuse::erosion
