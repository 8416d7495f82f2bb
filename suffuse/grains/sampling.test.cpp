#include "suffuse/grains/sampling.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/modeled_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::grains {
namespace {

Soil fontainebleau() {
    Soil soil;
    soil.whole = Grading{
        {0.10e-3, 0.15e-3, 0.18e-3, 0.21e-3, 0.25e-3, 0.30e-3, 0.40e-3}, {0, 0.08, 0.25, 0.50, 0.75, 0.92, 1}, "ne34"};
    soil.finer_than = 0.26e-3;
    return soil;
}

Grading band(double diameter) {
    return {{0.9 * diameter, 1.1 * diameter}, {0, 1}, "band"};
}

std::string complaint(const Soil& soil, int particles) {
    try {
        sample_soil(soil, particles);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

TEST(Sampling, FontainebleauSandIsFineByFourFifthsOfItsMass) {
    const Soil soil = fontainebleau();
    const SampledGrains sample = sample_soil(soil, 10000);
    ASSERT_EQ(sample.radius.size(), 10000U);
    const auto fines = std::accumulate(sample.fine.begin(), sample.fine.end(), 0);
    // The reference's sample, in 40 size classes, has 79.8 % of the mass and 9500 grains below 0.26 mm.
    EXPECT_NEAR(sample.fines_content, 0.798, 0.015);
    EXPECT_NEAR(fines, 9500, 50);
    EXPECT_NEAR(sample.fines_content, passing(*soil.whole, 0.26e-3), 5e-4); // one grain of that size: 2e-4 of the mass
}

TEST(Sampling, MissesTheCurveByLittleMoreThanHalfTheLargestGrain) {
    const Soil soil = fontainebleau();
    for (const int particles : {100, 1000, 10000}) {
        Soil tolerant = soil;
        tolerant.grading_tolerance = 1;
        const SampledGrains sample = sample_soil(tolerant, particles);
        double mass = 0;
        for (const double r : sample.radius) {
            mass += r * r * r;
        }
        const double largest = std::pow(sample.radius.front(), 3) / mass;
        EXPECT_GE(sample.largest_difference, 0.5 * largest - 1e-12) << particles; // no sample can do better
        EXPECT_LE(sample.largest_difference, 0.65 * largest) << particles;        // the step is not quite centered
    }
}

TEST(Sampling, CallsItsPulseWhileGrainsAreDrawn) {
    const Soil soil = fontainebleau();
    std::vector<long long> drawn;
    const SampledGrains sample = sample_soil(soil, 140'000, [&](std::string_view part, long long grains) {
        EXPECT_EQ(part, "draw");
        drawn.push_back(grains);
    });
    EXPECT_EQ(drawn, (std::vector<long long>{0, 65'536, 131'072}));
    EXPECT_EQ(sample.radius, sample_soil(soil, 140'000).radius) << "it only looks";
    const Pulse stop = [](std::string_view, long long) { throw Interrupted("asked to stop"); };
    EXPECT_THROW(sample_soil(soil, 140'000, stop), Interrupted);
}

TEST(Sampling, CurveOfTheSampleMeetsTheGradingAtItsPoints) {
    const Soil soil = fontainebleau();
    const SampledGrains sample = sample_soil(soil, 10000);
    const std::vector<double> found = sample_curve(sample.radius, soil.whole->diameter);
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k], soil.whole->passing[k], sample.largest_difference + 1e-12);
    }
    EXPECT_LT(sample.largest_difference, 1e-3);
    EXPECT_GT(sample.largest_difference, 1e-5);
}

TEST(Sampling, LargestDifferenceSeesBothSidesOfAStep) { // one size: F = 1/2 where the staircase jumps from 0 to 1
    const std::vector<double> radius(10, 0.5e-3 * std::sqrt(0.99));
    EXPECT_NEAR(largest_difference(radius, band(1e-3)), 0.5, 1e-12);
    const std::vector<double> coarse(10, 0.55e-3);
    EXPECT_NEAR(largest_difference(coarse, band(1e-3)), 1.0, 1e-12);
}

TEST(Sampling, OfTwoCurvesTheFinesEndHalfwayBetweenThemByRatio) {
    const auto curve = [](double least, double most) { return Grading{.diameter = {least, most}, .passing = {0, 1}}; };
    Soil soil;
    soil.fines_content = 0.2;
    soil.fines = curve(1e-4, 2e-4), soil.coarse = curve(8e-4, 9e-4);
    EXPECT_NEAR(*fines_limit(soil), 4e-4, 1e-16); // sqrt(2 x 8)
    soil.coarse = curve(2e-4, 9e-4);
    EXPECT_NEAR(*fines_limit(soil), 2e-4, 1e-16) << "curves that touch do not overlap";
    soil.coarse = curve(1.99e-4, 9e-4);
    EXPECT_THROW(fines_limit(soil), CaseError);
    EXPECT_FALSE(fines_limit({.whole = curve(1e-4, 9e-4)}));
}

TEST(Sampling, TwoFractionsGiveTheSpecifiedFinesContent) {
    Soil soil;
    soil.coarse = band(3.5e-4), soil.fines = band(1e-4), soil.fines_content = 0.20;
    const SampledGrains sample = sample_soil(soil, 5000);
    // Number of coarse grains by hand: (0.8/3.5^3)/(0.8/3.5^3 + 0.2) of all; half a grain of rounding.
    const double share = 0.8 / std::pow(3.5, 3) / (0.8 / std::pow(3.5, 3) + 0.2);
    const auto coarse = std::ranges::count(sample.fine, 0);
    EXPECT_NEAR(static_cast<double>(coarse), share * 5000, 0.5 + 1e-9);
    EXPECT_NEAR(sample.fines_content, 0.20, 0.2 * 0.8 * 0.5 / static_cast<double>(coarse)); // the same half grain
    EXPECT_LE(sample.largest_difference, 0.02);
    EXPECT_TRUE(std::ranges::is_sorted(sample.radius, std::greater<>()));
}

TEST(Sampling, PureFractionsAreAllowed) {
    Soil soil;
    soil.coarse = band(3.5e-4), soil.fines = band(1e-4);
    soil.fines_content = 0;
    EXPECT_EQ(sample_soil(soil, 1000).fines_content, 0);
    soil.fines_content = 1;
    EXPECT_EQ(sample_soil(soil, 1000).fines_content, 1);
}

TEST(Sampling, TooFewGrainsAreRefusedWithTheNumberThatWouldDo) {
    Soil soil;
    soil.whole = Grading{{0.1e-3, 5e-3}, {0, 1}, "wide.csv"};
    const std::string message = complaint(soil, 1000);
    EXPECT_NE(message.find("1000 particles cannot follow the grading wide.csv"), std::string::npos) << message;
    const double needed = grains_needed(*soil.whole, soil.grading_tolerance);
    EXPECT_NE(message.find(std::to_string(static_cast<long>(needed))), std::string::npos) << message;
    EXPECT_NO_THROW(sample_soil(soil, static_cast<int>(needed)));
    EXPECT_NE(complaint(soil, static_cast<int>(0.8 * needed)), ""); // the estimate is not wasteful either
}

TEST(Sampling, ACurveThatIsTooWideIsRefusedWithTheSizesAtWhichToCutIt) {
    Soil soil;
    soil.whole = Grading{{0.01e-3, 100e-3}, {0, 1}, "moraine.csv"};
    const std::string message = complaint(soil, 5000);
    EXPECT_NE(message.find("more than a thousand million"), std::string::npos) << message;
    const auto above = followed_above(*soil.whole, 5000, 0.02), below = followed_below(*soil.whole, 5000, 0.02);
    ASSERT_TRUE(above && below);
    EXPECT_GT(*above, 1e-3);
    EXPECT_LT(*below, 1e-3);
    const std::string ends = std::to_string(*above * 1e3).substr(0, 3);
    EXPECT_NE(message.find("above " + ends), std::string::npos) << message;
    soil.whole = part_between(*soil.whole, *above, 100e-3);
    EXPECT_NO_THROW(sample_soil(soil, 5000));
    soil.whole = Grading{{0.01e-3, 100e-3}, {0, 1}, "moraine.csv"};
    soil.finer_than = 0.1e-3; // cut above 1 mm, no fines would be left
    EXPECT_EQ(complaint(soil, 5000).find("above"), std::string::npos);
    EXPECT_NE(complaint(soil, 5000).find("below"), std::string::npos);
}

TEST(Sampling, FinesByKenneyAndLauWhereTheSplitExists) {
    Soil soil;
    soil.whole = Grading{{0.15e-3, 0.30e-3, 1e-3, 2e-3}, {0, 0.3, 0.3, 1}, "two boxes"};
    soil.kenney_lau = true;
    soil.grading_tolerance = 0.05;
    EXPECT_NEAR(sample_soil(soil, 5000).fines_content, 0.3, 0.01); // the split lies in the gap; one coarse grain: 1 %
    Soil sand = fontainebleau();
    sand.finer_than.reset();
    sand.kenney_lau = true;
    EXPECT_NE(complaint(sand, 10000).find("split does not exist"), std::string::npos);
}

TEST(Sampling, SoilsThatMakeNoSenseAreRefused) {
    Soil nothing;
    EXPECT_NE(complaint(nothing, 10).find("either one grading curve"), std::string::npos);
    EXPECT_NE(complaint(fontainebleau(), 0).find("at least 1"), std::string::npos);
    Soil outside = fontainebleau();
    outside.finer_than = 0.05e-3;
    EXPECT_NE(complaint(outside, 10000).find("no fines or no skeleton"), std::string::npos);
    Soil content;
    content.coarse = band(1e-3), content.fines = band(1e-4), content.fines_content = 20;
    EXPECT_NE(complaint(content, 10).find("fines content 20"), std::string::npos);
}

TEST(Sampling, PutsNoGrainIntoAGap) {
    const Grading grading{{0.1e-3, 0.11e-3, 0.3e-3, 0.5e-3, 0.55e-3}, {0, 0.2, 0.2, 0.2, 1}, ""};
    for (const std::size_t count : {50U, 300U, 3000U}) {
        for (const double d : sample_diameters(grading, count)) {
            EXPECT_TRUE(d <= 0.11e-3 || d >= 0.5e-3) << d << " of " << count;
        }
    }
}

} // namespace
} // namespace suffuse::grains
