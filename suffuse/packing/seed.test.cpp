#include "suffuse/packing/seed.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace suffuse::packing {
namespace {

grains::SampledGrains equal_grains(std::size_t count, double radius) {
    grains::SampledGrains sample;
    sample.radius.assign(count, radius);
    sample.fine.assign(count, 0);
    return sample;
}

grains::SampledGrains sample_of(grains::Grading grading, int particles) {
    grains::Soil soil;
    soil.whole = std::move(grading);
    soil.grading_tolerance = 1;
    return grains::sample_soil(soil, particles);
}

grains::SampledGrains fontainebleau(int particles) {
    return sample_of(
        {{0.10e-3, 0.15e-3, 0.18e-3, 0.21e-3, 0.25e-3, 0.30e-3, 0.40e-3}, {0, 0.08, 0.25, 0.50, 0.75, 0.92, 1}, ""},
        particles
    );
}

double porosity_of(const Cloud& cloud) {
    return 1 - grains::solid_volume(cloud.grains) / cell::volume(cloud.cell);
}

std::size_t overlaps_in(const Cloud& cloud) {
    return neighbors::find_pairs(cloud.cell.h, cloud.grains.position, cloud.grains.radius, 0.0).size();
}

TEST(Cloud, CallsItsPulseWhileGrainsArePlacedAndPushedApart) {
    const grains::SampledGrains sample = fontainebleau(9000);
    std::vector<long long> placed;
    int rounds = 0;
    const Pulse pulse = [&](std::string_view part, long long done) {
        if (part == "scatter") {
            placed.push_back(done);
        } else {
            ++rounds;
        }
    };
    const Cloud cloud = make_cloud(sample, {0.62}, 2600, 1, pulse);
    EXPECT_EQ(placed, (std::vector<long long>{0, 4096, 8192}));
    EXPECT_GT(rounds, 0);
    EXPECT_EQ(cloud.grains.position, make_cloud(sample, {0.62}, 2600, 1).grains.position) << "it only looks";
    const Pulse stop = [](std::string_view, long long) { throw Interrupted("asked to stop"); };
    EXPECT_THROW(make_cloud(sample, {0.62}, 2600, 1, stop), Interrupted);
}

TEST(Cloud, HasTheSpecifiedPorosityNoOverlapsAndTheGrainsOfTheSample) {
    const grains::SampledGrains sample = fontainebleau(10000);
    for (const double porosity : {0.62, 0.65}) {
        const Cloud cloud = make_cloud(sample, {porosity}, 2600, 1);
        EXPECT_EQ(cloud.grains.radius, sample.radius);
        EXPECT_EQ(overlaps_in(cloud), 0U);
        EXPECT_NEAR(porosity_of(cloud), porosity, 1e-12); // rounding
    }
}

TEST(Cloud, EqualSpheresGoBeyondWhereRandomAdditionSaturates) {
    const Cloud cloud = make_cloud(equal_grains(2000, 1e-4), {0.55}, 2600, 3); // addition alone ends at 0.62
    EXPECT_EQ(overlaps_in(cloud), 0U);
    EXPECT_NEAR(porosity_of(cloud), 0.55, 1e-12);
}

TEST(Cloud, GrainsLieInsideTheCellAndKeepTheirFractionAndDensity) {
    grains::SampledGrains sample = equal_grains(100, 1e-4);
    sample.fine[7] = 1;
    const Cloud cloud = make_cloud(sample, {0.7}, 2600, 1);
    for (const Vec3& x : cloud.grains.position) {
        for (int a = 0; a < 3; ++a) {
            EXPECT_TRUE(x[a] >= 0 && x[a] <= cloud.cell.h(a, a));
        }
    }
    EXPECT_EQ(std::ranges::count(cloud.grains.fine, 1), 1);
    EXPECT_EQ(cloud.grains.fine[7], 1);
    EXPECT_DOUBLE_EQ(cloud.grains.mass[0], 2600 * sphere_volume(1e-4));
}

TEST(Cloud, DependsOnTheSeedAndNotOnTheThreads) {
    const grains::SampledGrains sample = fontainebleau(2000);
    const int threads = thread_count();
    set_thread_count(1);
    const Cloud one = make_cloud(sample, {0.6}, 2600, 5);
    set_thread_count(4);
    const Cloud four = make_cloud(sample, {0.6}, 2600, 5);
    const Cloud other = make_cloud(sample, {0.6}, 2600, 6);
    set_thread_count(threads);
    EXPECT_EQ(one.grains.position, four.grains.position);
    EXPECT_NE(one.grains.position, other.grains.position);
}

TEST(Cloud, IsSpreadEvenlyOverTheCell) { // number of grains in each half: four standard deviations of a fair coin
    const Cloud cloud = make_cloud(fontainebleau(10000), {0.65}, 2600, 1);
    for (int a = 0; a < 3; ++a) {
        const auto low = std::ranges::count_if(cloud.grains.position, [&](const Vec3& x) {
            return x[a] < 0.5 * cloud.cell.h(a, a);
        });
        EXPECT_NEAR(static_cast<double>(low), 5000, 200);
    }
}

TEST(Cloud, SizeRatioOfTwentyWithAHundredThousandGrains) {
    const grains::SampledGrains sample = sample_of({{0.05e-3, 1e-3}, {0, 1}, ""}, 100000);
    const Cloud cloud = make_cloud(sample, {0.62}, 2600, 1);
    EXPECT_EQ(overlaps_in(cloud), 0U);
    EXPECT_NEAR(porosity_of(cloud), 0.62, 1e-12);
}

std::string complaint(const grains::SampledGrains& sample, double porosity) {
    try {
        make_cloud(sample, {porosity}, 2600, 1);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

TEST(Cloud, PorosityOutOfReachIsRefusedWithOneThatIsNot) {
    const grains::SampledGrains sample = equal_grains(200, 1e-4);
    const std::string message = complaint(sample, 0.30); // denser than random packings of spheres get
    ASSERT_NE(message.find("can be reached"), std::string::npos) << message;
    const double reachable = std::stod(message.substr(message.find("overlaps; ") + 10));
    EXPECT_GT(reachable, 0.35);
    EXPECT_LT(reachable, 0.50);
    EXPECT_NE(complaint(sample, 1.2).find("between 0 and 1"), std::string::npos);
}

TEST(Cloud, SampleTooSmallForItsLargestGrainIsRefused) {
    grains::SampledGrains sample = equal_grains(20, 1e-4);
    sample.radius.front() = 1e-3;
    const std::string message = complaint(sample, 0.65);
    EXPECT_NE(message.find("narrower than two of the largest grain (2 mm)"), std::string::npos) << message;
}

} // namespace
} // namespace suffuse::packing
