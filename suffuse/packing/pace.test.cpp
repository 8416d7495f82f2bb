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

TEST(Loaded, IsASampleThatBearsNineTenthsOfItsPressure) {
    CompactSpec spec;
    spec.pressure = 100e3;
    CompactState state;
    state.balance.stress = diagonal({89e3, 89e3, 89e3});
    EXPECT_FALSE(is_loaded(spec, state));
    state.balance.stress = diagonal({91e3, 91e3, 91e3});
    EXPECT_TRUE(is_loaded(spec, state));
}

} // namespace
} // namespace suffuse::packing
