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

TEST(ErosionLoop, ARuleOfTheCallersOwnIsRefusedWhereNoProbeAsksOne) {
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
