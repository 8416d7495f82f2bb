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
    try {
        erode_once(world, {}, {}, result);
        FAIL() << "it was eroded";
    } catch (const StateError& error) {
        EXPECT_NE(std::string(error.what()).find("all grains are fines"), std::string::npos) << error.what();
    }
    EXPECT_EQ(world.grains.position, before);
    EXPECT_TRUE(result.passes.empty());
}

} // namespace
} // namespace suffuse::erosion
