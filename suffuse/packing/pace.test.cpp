#include "suffuse/packing/pace.hpp"

#include <gtest/gtest.h>

namespace suffuse::packing {
namespace {

TEST(LargestRate, IsTheReferencesForItsSandAndOneInertialNumberForAll) {
    CompactSpec spec;
    spec.pressure = 100e3;
    EXPECT_NEAR(largest_rate(spec, 2600, 0.21e-3), 250, 0.1);
    EXPECT_NEAR(largest_rate(spec, 2600, 21e-3), 2.5, 0.001);
    spec.pressure = 400e3;
    EXPECT_NEAR(largest_rate(spec, 2600, 0.21e-3), 500, 0.2);
    spec.max_rate = 7;
    EXPECT_EQ(largest_rate(spec, 2600, 0.21e-3), 7);
}

} // namespace
} // namespace suffuse::packing
