#include "suffuse/stability/burenkova.hpp"

#include "suffuse/stability/gradings_for_tests.hpp"

#include <gtest/gtest.h>

namespace suffuse::stability {
namespace {

using testing::box;
using testing::power_law;
using testing::two_boxes;

TEST(Burenkova, SlopesOfAPowerLawAreClosedForms) {
    // h' = 1.5^(1/m), h'' = 6^(1/m); Fuller: 2.25 in the band from 2.183 to 3.895.
    for (const double m : {0.3, 0.5, 0.7}) {
        EXPECT_NEAR(*burenkova(power_law(m)).value, std::pow(1.5, 1 / m), 1e-9);
        EXPECT_NEAR(*burenkova(power_law(m)).limit, 0.76 * std::log10(6) / m + 1, 1e-9);
    }
    const Criterion fuller = burenkova(power_law(0.5));
    EXPECT_NEAR(*fuller.value, 2.25, 1e-9);
    EXPECT_NEAR(*fuller.limit, 2.183, 5e-4);
    EXPECT_NEAR(*fuller.upper, 3.895, 5e-4);
    EXPECT_EQ(fuller.verdict, Verdict::Stable);
}

TEST(Burenkova, CannotSayBeyondWhatWasTested) {
    EXPECT_EQ(burenkova(power_law(0.5, 0.11)).verdict, Verdict::CannotSay);
    EXPECT_NE(burenkova(power_law(0.5, 0.11)).remark.find("tested up to 100 mm"), std::string::npos);
    // D60/D10 = 6^(1/m) > 200 for m < 0.338.
    EXPECT_EQ(burenkova(power_law(0.33)).verdict, Verdict::CannotSay);
    EXPECT_EQ(burenkova(power_law(0.35)).verdict, Verdict::Stable);
}

TEST(WanFell, GivesTheLogisticFormOfASandGravel) {
    const grains::Grading grading = power_law(0.7, 20e-3); // 2 % finer than 0.075 mm
    const double slope = std::pow(1.5, 1 / 0.7), z = 3.875 * std::log10(6) / 0.7 - 3.591 * slope + 2.436;
    const Criterion criterion = wan_fell(grading, std::nullopt);
    EXPECT_NEAR(*criterion.value, std::exp(z) / (1 + std::exp(z)), 1e-9);
    EXPECT_EQ(criterion.verdict, Verdict::Unstable);
}

TEST(WanFell, GivesTheLogisticFormOfASiltSandGravel) {
    const grains::Grading grading = power_law(0.4, 10e-3); // 14 % finer than 0.075 mm, 3 % of clay
    const double slope = std::pow(1.5, 2.5), z = 2.378 * std::log10(6) * 2.5 - 3.648 * slope + 3.701;
    EXPECT_NEAR(*wan_fell(grading, std::nullopt).value, std::exp(z) / (1 + std::exp(z)), 1e-9);
    EXPECT_EQ(wan_fell(grading, std::nullopt).verdict, Verdict::Stable);
    EXPECT_EQ(wan_fell(grading, FineFraction{1e-4, 0.14}).verdict, Verdict::CannotSay);
    EXPECT_EQ(wan_fell(grading, FineFraction{1e-4, 0.16}).verdict, Verdict::Stable);
}

TEST(WanFell, TakesTheFitOfSiltsWhereMoreThanATenthIsFinerThanSieve200) {
    const auto fit = [](double tenth_at) { // 10 % are finer than this
        return wan_fell({{0.01e-3, tenth_at, 1e-3, 10e-3}, {0, 0.1, 0.5, 1}, ""}, std::nullopt).remark;
    };
    EXPECT_NE(fit(0.074e-3).find("fit for silt-sand-gravel"), std::string::npos) << fit(0.074e-3);
    EXPECT_NE(fit(0.076e-3).find("fit for sand-gravel"), std::string::npos) << fit(0.076e-3);
}

TEST(WanFell, CannotSayWhereItWasNotFitted) {
    EXPECT_NE(wan_fell(box(0.2e-3, 0.4e-3), std::nullopt).remark.find("gravel"), std::string::npos);
    EXPECT_NE(wan_fell(power_law(0.2), std::nullopt).remark.find("of clay"), std::string::npos);
    const auto with_clay = [](double share) {
        return wan_fell({{0.001e-3, 0.002e-3, 1e-3, 10e-3}, {0, share, 0.5, 1}, ""}, std::nullopt).remark;
    };
    EXPECT_NE(with_clay(0.101).find("of clay"), std::string::npos) << with_clay(0.101);
    EXPECT_EQ(with_clay(0.099).find("of clay"), std::string::npos) << with_clay(0.099);
    // Nearly all of the curve between d15 and d60, a long coarse tail: h' above 1.86 log h'' + 1.
    const grains::Grading concave_down{{0.9e-3, 1e-3, 1.1e-3, 40e-3}, {0, 0.1, 0.65, 1}, ""};
    EXPECT_NE(wan_fell(concave_down, std::nullopt).remark.find("above Burenkova's band"), std::string::npos);
    for (const auto& grading : {box(0.2e-3, 0.4e-3), concave_down}) {
        EXPECT_EQ(wan_fell(grading, std::nullopt).verdict, Verdict::CannotSay);
    }
}

TEST(WanFellAlternative, PartsSteepCoarseAndFlatFineSlopesFromTheOthers) {
    const FineFraction fines{0.2e-3, 0.25};
    // d90/d60 = x and d20/d5 = y by construction; 12 % finer than 0.075 mm.
    const auto soil = [](double coarse, double fine) {
        const double d5 = 0.02e-3, d60 = 8e-3;
        return grains::Grading{
            {d5 / 2, d5, d5 * fine, d60, d60 * coarse, d60 * coarse * 1.1}, {0, 0.05, 0.20, 0.60, 0.90, 1}, ""};
    };
    EXPECT_EQ(wan_fell_alternative(soil(2.0, 8), fines).verdict, Verdict::Unstable);   // 99.7, 16.6
    EXPECT_EQ(wan_fell_alternative(soil(2.5, 8), fines).verdict, Verdict::Transition); // 75.4, 16.6
    EXPECT_EQ(wan_fell_alternative(soil(3.0, 8), fines).verdict, Verdict::Stable);     // 62.9
    EXPECT_EQ(wan_fell_alternative(soil(2.0, 4), fines).verdict, Verdict::Stable);     // 24.9
    EXPECT_EQ(wan_fell_alternative(soil(2.0, 8), std::nullopt).verdict, Verdict::CannotSay);
    EXPECT_EQ(wan_fell_alternative(two_boxes(0.25), fines).verdict, Verdict::CannotSay);
}

} // namespace
} // namespace suffuse::stability
