#include "suffuse/answer/headlines.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"
#include <cmath>

namespace suffuse::answer {
namespace {

TEST(Headlines, SayMassPermeabilityStressAndFindings) {
    const erosion::ErosionResult erosion = test::sample_erosion();
    std::vector<study::Finding> findings(7);
    findings[0].met = findings[3].met = true;
    findings[1].met = false;
    const std::vector<Headline> headlines = erosion_headlines(erosion);
    ASSERT_EQ(headlines.size(), 3U);
    EXPECT_EQ(headlines[0].value, "14.7 %"); // (0.0764 + 0.012)/0.6
    EXPECT_EQ(headlines[0].detail, "in 2 passes at i = 0.05");
    EXPECT_EQ(headlines[1].value, "× 3.52"); // 1.9e-10/5.4e-11
    EXPECT_EQ(headlines[2].value, "−28 %");
    EXPECT_EQ(headlines[2].detail, "after pass 2, the largest loss");
    const std::optional<Headline> met = findings_headline(findings);
    EXPECT_EQ(met.value().value, "2 of 7");
    EXPECT_EQ(met.value().detail, "1 not met; 4 cannot tell");
    EXPECT_FALSE(findings_headline({}).has_value());
}

TEST(Headlines, OfFinesAreTheThresholdsThatWereFound) {
    using enum study::ThresholdKind;
    const std::vector<study::ContentThreshold> thresholds = {
        {LowestLoose, study::scatter_of({0.40, 0.42})},
        {LowestBetween, study::scatter_of({0.38}), 0.25},
        {ActiveFines, study::scatter_of({0.331, std::nan("")})},
        {StrongContacts, study::scatter_of({})}};
    const std::vector<Headline> headlines = fines_headlines(thresholds);
    ASSERT_EQ(headlines.size(), 2U);
    EXPECT_EQ(headlines[0].value, "41 ± 1.4 %"); // sqrt(2)
    EXPECT_EQ(headlines[0].label, "FC_threshold");
    EXPECT_EQ(headlines[1].value, "33 %");
    EXPECT_EQ(headlines[1].detail, "active fines b begin to rise, in 1 of 2 seeds");
}

TEST(Headlines, AChangeThatIsNoiseIsNone) {
    erosion::ErosionResult erosion = test::sample_erosion();
    for (erosion::PassResult& pass : erosion.passes) {
        pass.stress_constant_volume = (1 - 1e-9) * pass.stress_before;
    }
    EXPECT_EQ(erosion_headlines(erosion)[2].value, "unchanged");
}

TEST(Headlines, LeaveOutWhatTheRunCannotTell) {
    EXPECT_TRUE(erosion_headlines({}).empty());
    erosion::ErosionResult erosion;
    erosion.passes.emplace_back().pass = 1;
    const std::vector<Headline> headlines = erosion_headlines(erosion);
    ASSERT_EQ(headlines.size(), 1U);
    EXPECT_EQ(headlines[0].detail, "in 1 pass");
}

} // namespace
} // namespace suffuse::answer
