#include "suffuse/packing/target_density.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::packing {
namespace {

/// A made-up sample: 0.5 frictionless, 0.7 at the final friction, 1.1 with 1 MPa of adhesion, curved in between.
double made_up_void_ratio(const CompactSpec& spec, const grains::Material& final_material) {
    const double friction = spec.prepare.friction.value_or(0) / final_material.friction;
    const double adhesion = spec.prepare.adhesion_normal.value_or(0) / 1e6;
    return 0.5 + 0.2 * friction * friction + 0.4 * adhesion;
}

CompactSpec wanted(double void_ratio) {
    CompactSpec spec;
    spec.pressure = 100e3;
    spec.void_ratio = void_ratio;
    return spec;
}

class TargetDensity : public testing::TestWithParam<double> {};

TEST_P(TargetDensity, IsMetWithinTheTolerance) {
    const grains::Material material;
    const FoundDensity found = search_void_ratio(wanted(GetParam()), material, [&](const CompactSpec& spec) {
        return made_up_void_ratio(spec, material);
    });
    EXPECT_NEAR(found.void_ratio, GetParam(), 0.002);
    EXPECT_LE(found.trials, 10);
    EXPECT_EQ(made_up_void_ratio(found.spec, material), found.void_ratio);
}

INSTANTIATE_TEST_SUITE_P(Packing, TargetDensity, testing::Values(0.501, 0.55, 0.62, 0.7, 0.8, 1.05));

TEST(TargetDensity, OutOfReachNamesTheRange) {
    const grains::Material material;
    const auto reach = [&](const CompactSpec& spec) { return made_up_void_ratio(spec, material); };
    for (const double void_ratio : {0.4, 1.3}) {
        try {
            search_void_ratio(wanted(void_ratio), material, reach);
            FAIL() << void_ratio;
        } catch (const StateError& error) {
            const std::string text = error.what();
            EXPECT_NE(text.find("0.5000"), std::string::npos) << text;
            EXPECT_NE(text.find("1.1000"), std::string::npos) << text;
        }
    }
}

TEST(TargetDensity, TheNearestIsTakenWhereTheCaseSpecifiesIt) {
    const grains::Material material;
    CompactSpec spec = wanted(1.3);
    spec.if_unreachable = IfUnreachable::Nearest;
    CompactSpec last;
    const FoundDensity found = search_void_ratio(spec, material, [&](const CompactSpec& trial) {
        last = trial;
        return made_up_void_ratio(trial, material);
    });
    EXPECT_FALSE(found.is_met);
    EXPECT_NEAR(found.void_ratio, 1.1, 1e-12); // the loosest on offer
    EXPECT_EQ(made_up_void_ratio(last, material), found.void_ratio);
    EXPECT_GT(last.void_ratio_tolerance, 1e9) << "a trial that is taken although it misses must not end early";
}

TEST(TargetDensity, ScatterOfSingleSamplesDoesNotBeatTheSearch) {
    const grains::Material material;
    for (int seed = 0; seed < 50; ++seed) {
        // Twice the tolerance to both sides, another for every preparation, the same for the same one.
        const auto reach = [&](const CompactSpec& spec) {
            const double friction = *spec.prepare.friction;
            const double chance = std::sin(43758.5453 * std::sin(1e3 * friction + seed));
            return made_up_void_ratio(spec, material) + 0.02 * chance;
        };
        CompactSpec spec = wanted(0.6);
        spec.void_ratio_tolerance = 0.01;
        EXPECT_NO_THROW({
            const FoundDensity found = search_void_ratio(spec, material, reach);
            EXPECT_NEAR(found.void_ratio, 0.6, 0.01);
        }) << seed;
    }
}

} // namespace
} // namespace suffuse::packing
