#include "suffuse/erosion/detachment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::erosion {
namespace {

/// Fines of free-flight speed 1 and free displacement 1, each with the speeds of the eleven samples.
ProbeResult probe_of(const std::vector<std::array<double, probe_samples + 1>>& speeds) {
    ProbeResult result;
    for (std::size_t k = 0; k < speeds.size(); ++k) {
        result.id.push_back(static_cast<std::uint32_t>(k));
        result.diameter.push_back(2);
        result.fluid_force.push_back(1);
        result.coordination.push_back(0);
        result.speed.push_back(speeds[k]);
        result.twin_speed.push_back(0);
        result.displacement.push_back(0);
        result.free_speed.push_back(1);
        result.free_displacement.push_back(1);
    }
    return result;
}

std::array<double, probe_samples + 1> rising_to(double end) {
    std::array<double, probe_samples + 1> speed{};
    for (int k = 0; k <= probe_samples; ++k) {
        speed[static_cast<std::size_t>(k)] = end * (k + 1) / (probe_samples + 1);
    }
    return speed;
}

TEST(Detachment, AGrainThatFliesFreeIsDetachableAndOneThatFluctuatesIsNot) {
    auto fluctuating = rising_to(1);
    std::swap(fluctuating[5], fluctuating[6]);
    ProbeResult probe = probe_of({rising_to(1), fluctuating, rising_to(0.4)});
    judge_detachment({}, probe);
    EXPECT_EQ(probe.by_velocity, (std::vector<std::uint8_t>{1, 0, 0})); // the last is too slow for half of free flight
}

TEST(Detachment, ASpeedThatStaysTheSameOverATenthOfTheWatchDoesNotRise) {
    std::array<double, probe_samples + 1> level = rising_to(1), barely = level;
    level[6] = level[5];
    barely[6] = std::nextafter(barely[5], 2);
    ProbeResult probe = probe_of({level, barely});
    judge_detachment({}, probe);
    EXPECT_EQ(probe.by_velocity, (std::vector<std::uint8_t>{0, 1}));
}

TEST(Detachment, AGrainThatMovesWithoutFluidAsWellIsNotDetachableAndHidesNoOther) {
    std::vector<std::array<double, probe_samples + 1>> speeds(40, rising_to(1));
    speeds[0] = speeds[1] = rising_to(9);             // a chain that creeps, and gains speed
    std::reverse(speeds[1].begin(), speeds[1].end()); // or comes to rest
    ProbeResult probe = probe_of(speeds);
    probe.twin_speed[0] = speeds[0].back() - 0.1;
    probe.twin_speed[1] = speeds[1].back();
    judge_detachment({}, probe);
    EXPECT_EQ(probe.by_velocity[0], 0);
    EXPECT_EQ(probe.by_velocity[1], 0);
    EXPECT_EQ(std::accumulate(probe.by_velocity.begin(), probe.by_velocity.end(), 0), 38);
    EXPECT_EQ(probe.hidden_by_noise, 1);              // the other would not be detachable with a twin at rest either
    EXPECT_EQ(probe.twin_noise, probe.twin_speed[0]); // reported; it judges no grain
    EXPECT_FALSE(noise_decides({}, probe));
}

TEST(Detachment, AGrainThatMovesWithoutFluidIsDetachableWhereTheFluidAddsHalfOfFreeFlight) {
    ProbeResult probe = probe_of({rising_to(3.6), rising_to(3.4)});
    probe.twin_speed = {3, 3};
    judge_detachment({}, probe);
    EXPECT_EQ(probe.by_velocity, (std::vector<std::uint8_t>{1, 0}));
}

TEST(Detachment, IsUndecidedWhereMoreThanATwentiethOfTheFinesWouldMoveWithoutFluidAsWell) {
    std::vector<std::array<double, probe_samples + 1>> speeds(40, rising_to(1));
    DetachSpec spec;
    for (const auto& [hidden, decides] : {std::pair{2, false}, std::pair{3, true}}) {
        ProbeResult probe = probe_of(speeds);
        for (int k = 0; k < hidden; ++k) {
            probe.twin_speed[static_cast<std::size_t>(k)] = 0.8;
        }
        judge_detachment(spec, probe);
        EXPECT_EQ(probe.hidden_by_noise, hidden);
        EXPECT_EQ(std::accumulate(probe.by_velocity.begin(), probe.by_velocity.end(), 0), 40 - hidden);
        EXPECT_EQ(noise_decides(spec, probe), decides);
    }
}

TEST(Detachment, TheSignalIsClearFromTenTimesTheTwinOn) {
    ProbeResult probe;
    probe.signal_over_twin = 9.9;
    EXPECT_FALSE(has_clear_signal(probe));
    probe.signal_over_twin = 10;
    EXPECT_TRUE(has_clear_signal(probe));
}

TEST(Detachment, WithoutFluidForceNoRuleReturnsAGrain) {
    for (const VelocityRule rule : {VelocityRule::StillAccelerating, VelocityRule::Rising, VelocityRule::Above}) {
        ProbeResult probe = probe_of({rising_to(1)});
        probe.fluid_force = {0};
        probe.displacement = {5};
        DetachSpec spec;
        spec.rule = rule;
        judge_detachment(spec, probe);
        EXPECT_EQ(probe.by_velocity[0], 0);
        EXPECT_EQ(probe.by_displacement[0], 0);
    }
}

TEST(Detachment, TheOtherReadingsRequireLess) {
    ProbeResult probe = probe_of({rising_to(0.4)});
    DetachSpec rising;
    rising.rule = VelocityRule::Rising;
    judge_detachment(rising, probe);
    EXPECT_EQ(probe.by_velocity[0], 1);
    DetachSpec above;
    above.rule = VelocityRule::Above;
    above.over_speed = 0.5;
    judge_detachment(above, probe);
    EXPECT_EQ(probe.by_velocity[0], 0);
    above.over_speed = 0.3;
    judge_detachment(above, probe);
    EXPECT_EQ(probe.by_velocity[0], 1);
}

TEST(Detachment, DisplacementCountsAgainstFreeFlightOrTheDiameter) {
    ProbeResult probe = probe_of({rising_to(1), rising_to(1), rising_to(1)});
    probe.displacement = {0.6, 0.4, -0.9};
    DetachSpec spec;
    spec.by = DetachBy::Displacement;
    judge_detachment(spec, probe);
    EXPECT_EQ(verdicts(spec, probe), (std::vector<std::uint8_t>{1, 0, 0}));
    spec.over_diameters = 0.1; // of a diameter of 2
    judge_detachment(spec, probe);
    EXPECT_EQ(verdicts(spec, probe), (std::vector<std::uint8_t>{1, 1, 0}));
}

TEST(Detachment, TheTwoWayTableCountsEveryGrainOnce) {
    ProbeResult probe = probe_of({rising_to(1), rising_to(1), rising_to(0.1), rising_to(0.1)});
    probe.displacement = {1, 0, 1, 0};
    judge_detachment({}, probe);
    EXPECT_EQ(probe.agreement[1][1], 1);
    EXPECT_EQ(probe.agreement[1][0], 1);
    EXPECT_EQ(probe.agreement[0][1], 1);
    EXPECT_EQ(probe.agreement[0][0], 1);
}

TEST(Detachment, AThresholdTakesNoiseWhereTheTwinDoesNotAcceptItsGrains) {
    std::vector<std::array<double, probe_samples + 1>> speeds(40, rising_to(0.1));
    ProbeResult probe = probe_of(speeds);
    std::fill(probe.displacement.begin(), probe.displacement.end(), 1);
    DetachSpec spec;
    spec.rule = VelocityRule::Above, spec.over_speed = 0.05;
    probe.displacement[0] = probe.displacement[1] = 0; // 5 %: bounces
    judge_detachment(spec, probe);
    EXPECT_FALSE(threshold_takes_noise(spec, probe));
    probe.displacement[2] = 0;
    judge_detachment(spec, probe);
    EXPECT_TRUE(threshold_takes_noise(spec, probe));
    spec.by = DetachBy::Displacement;
    EXPECT_FALSE(threshold_takes_noise(spec, probe)) << "it is the twin's rule that decides";
    spec = {};
    EXPECT_FALSE(threshold_takes_noise(spec, probe)) << "the strict rule looks at the twin itself";
    EXPECT_FALSE(threshold_takes_noise(spec, ProbeResult{}));
}

TEST(Detachment, FreeTravelIsWhatOneFineGrainInTwentyGoesBeyond) {
    ProbeResult probe = probe_of(std::vector(21, rising_to(1))); // of diameter 2
    for (std::size_t k = 0; k < 21; ++k) {
        probe.free_displacement[k] = 2e-4 * static_cast<double>(k); // 0 to 20 ten-thousandths of a diameter
    }
    EXPECT_NEAR(free_travel(probe), 19e-4, 1e-16);
    EXPECT_EQ(free_travel({}), 0);
}

} // namespace
} // namespace suffuse::erosion
