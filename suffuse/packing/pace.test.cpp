#include "suffuse/packing/pace.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

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

TEST(Pace, TheStrainRateFallsAtAFiftiethAndAtHalfOfThePressure) {
    dem::World world = test::empty_world(1e-2);
    test::add(world, {}, 0.2e-3);
    CompactSpec spec;
    spec.pressure = 100e3;
    CompactState state;
    state.median_diameter = 0.4e-3;
    const double most = largest_rate(spec, world.material.density, state.median_diameter);
    for (const auto& [share, rate] :
         {std::pair{0.019, 1.0}, std::pair{0.021, 0.2}, std::pair{0.49, 0.2}, std::pair{0.51, 0.08}}) {
        state.balance.stress = diagonal({share * spec.pressure, share * spec.pressure, share * spec.pressure});
        EXPECT_DOUBLE_EQ(choose_pace(world, spec, {}, state).plan.loading.servo.max_rate.value(), rate * most) << share;
    }
}

TEST(Slow, TakesThreeTenthsOfThePWaveTimeOfTheSmallestGrain) {
    const grains::Material material;
    const double p_wave = 1e-4 * std::sqrt(material.density / material.modulus);
    EXPECT_NEAR(slow_time_step(1e-4, material), 0.3 * p_wave, 1e-12 * p_wave);
}

TEST(Wide, LendsGentlyUpToAMedianGrainFifteenTimesTheSmallest) {
    EXPECT_TRUE(lent_to_wide(14.9).gently);
    EXPECT_FALSE(lent_to_wide(15.1).gently);
}

/// What `wide` lends grains of 0.4 mm and of `smallest` in a phase, under a share of the pressure.
dem::Lent lent_by_wide(const Prepare& prepare, CompactState::Phase phase, double share, double smallest = 0.04e-3) {
    dem::World world = test::empty_world(1e-2);
    test::add(world, {}, 0.2e-3);
    test::add(world, {}, smallest / 2);
    CompactSpec spec;
    spec.pressure = 100e3;
    spec.protocol = Protocol::Wide;
    spec.prepare = prepare;
    CompactState state;
    state.phase = phase;
    state.median_diameter = 0.4e-3;
    state.balance.stress = diagonal({share * spec.pressure, share * spec.pressure, share * spec.pressure});
    return choose_lent(world, spec, state);
}

TEST(Wide, LendsTheSameFromTheFirstStepOnUnlessASkeletonCollapses) {
    using Phase = CompactState::Phase;
    const dem::Lent gently{.mass = true, .gently = true, .fines_rotation = true};
    const dem::Lent more{.mass = true, .fines_rotation = true};
    for (const double share : {0.0, 0.5, 1.0}) {
        EXPECT_EQ(lent_by_wide({}, Phase::Compact, share), gently);
        EXPECT_EQ(lent_by_wide({.friction = 0}, Phase::Settle, share), gently);
        EXPECT_EQ(lent_by_wide({}, Phase::Compact, share, 0.02e-3), more); // twenty times smaller
        EXPECT_EQ(lent_by_wide({}, Phase::Prove, share), dem::Lent{});
    }
    const Prepare adhesion{.adhesion_normal = 1e6, .adhesion_shear = 1e6};
    EXPECT_EQ(lent_by_wide(adhesion, Phase::Compact, 0.5), (dem::Lent{true, true}));
    EXPECT_EQ(lent_by_wide(adhesion, Phase::Settle, 0.5), dem::Lent{.fines_rotation = true}); // it collapses
    EXPECT_EQ(lent_by_wide(adhesion, Phase::Settle, 1.0), (dem::Lent{true, true}));
}

} // namespace
} // namespace suffuse::packing
