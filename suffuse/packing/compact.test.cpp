#include "suffuse/packing/compact.hpp"

#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::packing {
namespace {

TEST(MissesVoidRatio, OfASwiftSampleThatSettlesOneAndAHalfTolerancesTooDense) {
    dem::World world = test::empty_world(4e-3);
    test::add(world, {}, 1e-3);
    CompactSpec spec;
    spec.protocol = Protocol::Swift;
    CompactState state;
    state.phase = CompactState::Phase::Settle;
    const auto misses = [&](double tolerances) { // below the specified void ratio
        spec.void_ratio = dem::void_ratio(world) + tolerances * spec.void_ratio_tolerance;
        return misses_void_ratio(world, spec, state);
    };
    EXPECT_FALSE(misses(1.49));
    EXPECT_TRUE(misses(1.51));
    EXPECT_FALSE(misses(-10)) << "it may still become denser";
    state.phase = CompactState::Phase::Prove; // settled: within a tolerance to either side
    EXPECT_FALSE(misses(0.99) || misses(-0.99));
    EXPECT_TRUE(misses(1.01) && misses(-1.01));
}

} // namespace
} // namespace suffuse::packing
