#include "suffuse/flow/known_error.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/flow/seepage.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"

namespace suffuse::flow {
namespace {

using Marks = std::vector<std::uint8_t>;

/// Coarse grains of 1, fines of a size.
Mixture mixture_of(std::size_t coarse, std::size_t fines, double size, double solid_fraction) {
    std::vector<double> radius(coarse, 1.0);
    Marks fine(coarse, 0);
    radius.insert(radius.end(), fines, size);
    fine.insert(fine.end(), fines, 1);
    double cubes = 0;
    for (const double r : radius) {
        cubes += r * r * r;
    }
    return describe_mixture(radius, fine, 4 * pi / 3 * cubes / solid_fraction);
}

TEST(Mixture, HasTheNumbersOfItsTwoKinds) {
    const Mixture mixture = mixture_of(10, 300, 0.2, 0.6);
    EXPECT_EQ(mixture.coarse, 10U);
    EXPECT_EQ(mixture.fines, 300U);
    EXPECT_NEAR(mixture.size_ratio, 5, 1e-12);
    EXPECT_NEAR(mixture.fines_content, 300 * 0.008 / (10 + 300 * 0.008), 1e-12);
    EXPECT_NEAR(mixture.solid_fraction, 0.6, 1e-12);
    EXPECT_EQ(mixture_of(10, 0, 0.2, 0.6).size_ratio, 1);
}

TEST(FinesOfSizes, AreThoseBelowTheWidestGap) {
    const std::vector<double> radius = {1, 0.1, 0.9, 0.11, 1.1};
    EXPECT_EQ(distinguish_fines(radius), (Marks{0, 1, 0, 1, 0}));
    const std::vector<double> continuous = {1, 1.3, 1.6, 2.0};
    EXPECT_EQ(distinguish_fines(continuous), (Marks{0, 0, 0, 0}));
    EXPECT_EQ(distinguish_fines({}), Marks{});
}

TEST(KnownErrors, AreWiderWhereFinesAreFew) {
    const auto permeability = [](const Mixture& mixture) {
        return known_error(Conductance::Bounded, mixture).permeability.value();
    };
    EXPECT_EQ(permeability(mixture_of(50, 2000, 0.2, 0.6)), 0.12);
    EXPECT_EQ(permeability(mixture_of(50, 49, 0.2, 0.6)), 0.20);
    EXPECT_EQ(permeability(mixture_of(500, 60, 0.2, 0.6)), 0.20); // 0.1 % of the solids
    EXPECT_EQ(permeability(mixture_of(50, 0, 0.2, 0.6)), 0.12);
    const KnownError cloud = known_error(Conductance::Bounded, mixture_of(50, 0, 0.2, 0.4));
    EXPECT_EQ(cloud.permeability, 0.12);
    EXPECT_EQ(cloud.force, std::nullopt);
}

TEST(KnownErrors, GrowWithOverlapsUntilNoneIsKnown) {
    const auto permeability = [](double overlap) {
        return known_error(Conductance::Bounded, {0.6, 5, 0.2, 500, 50, overlap}).permeability;
    };
    EXPECT_EQ(permeability(0.019), 0.12);
    EXPECT_EQ(permeability(0.021), 0.20);
    EXPECT_EQ(permeability(0.149), 0.20);
    EXPECT_EQ(permeability(0.151), std::nullopt);
}

TEST(KnownErrors, AreNoneWhereTheFlowKeepsToChannels) {
    for (const auto& [solid_fraction, limit] : {std::pair{0.6, 1.38}, {0.3, 1.28}}) {
        const Mixture even{solid_fraction, 5, 0.2, 500, 50, 0, limit - 0.01};
        const Mixture channels{solid_fraction, 5, 0.2, 500, 50, 0, limit + 0.01};
        EXPECT_EQ(known_error(Conductance::Bounded, even).permeability, 0.12);
        EXPECT_EQ(known_error(Conductance::Bounded, channels).permeability, std::nullopt);
        EXPECT_EQ(doubt_network(even, 0.9), Doubt::None);
        EXPECT_EQ(doubt_network(channels, 0.9), Doubt::Channels);
    }
}

TEST(KnownErrors, AreWiderBeyondASizeRatioOfTen) {
    EXPECT_EQ(known_error(Conductance::Bounded, {0.6, 9.9, 0.2, 500, 50}).permeability, 0.12);
    EXPECT_EQ(known_error(Conductance::Bounded, {0.6, 10.1, 0.2, 500, 50}).permeability, 0.20);
}

TEST(KnownErrors, AreThoseOfAMixtureFromSizesOfOneAndAHalfAndAHundredthOfFinesOn) {
    const auto permeability = [](double ratio, double fines_content) {
        return known_error(Conductance::Bounded, {0.6, ratio, fines_content, 50, 500}).permeability.value();
    };
    EXPECT_EQ(permeability(1.45, 0.005), 0.12);
    EXPECT_EQ(permeability(1.55, 0.005), 0.20);
    EXPECT_EQ(permeability(5, 0.0099), 0.20);
    EXPECT_EQ(permeability(5, 0.0101), 0.12);
}

TEST(Doubts, OfFinesThatRaiseThePermeabilityBeginAboveTwoHundredths) {
    const Mixture mixture{0.6, 5, 0.2, 500, 500};
    EXPECT_EQ(doubt_network(mixture, 1.019), Doubt::None);
    EXPECT_EQ(doubt_network(mixture, 1.021), Doubt::RaisedByFines);
}

TEST(KnownErrors, OfYadesLawGrowWithTheRatioUntilNoneIsKnown) {
    const auto permeability = [](const Mixture& mixture) {
        return known_error(Conductance::Yade, mixture).permeability;
    };
    EXPECT_EQ(permeability(mixture_of(50, 0, 1, 0.65)), 0.05);
    EXPECT_NEAR(permeability(mixture_of(50, 0, 1, 0.599)).value(), 0.13, 1e-12); // half way between two measured
    EXPECT_EQ(permeability(mixture_of(50, 0, 1, 0.4)), std::nullopt);
    double before = 0.25;
    for (const double size : {0.3, 0.2, 0.12}) {
        const double error = permeability(mixture_of(50, 2000, size, 0.6)).value();
        EXPECT_GT(error, before);
        before = error;
    }
    EXPECT_EQ(permeability(mixture_of(50, 2000, 0.05, 0.6)), std::nullopt);
}

TEST(CoarsePermeability, IsThatOfTheCoarseGrainsAlone) {
    test::Packing packing = test::lattice(2, 1, 0.42, {{0.1, 0.2, 0.3}});
    const Fluid fluid;
    const Vec3 along{0, 0, 1};
    const auto of_coarse = [&] {
        const std::vector<std::uint8_t> fine = distinguish_fines(packing.radius);
        return coarse_permeability({packing.h, {}}, packing.position, packing.radius, fine, along, fluid);
    };
    EXPECT_EQ(of_coarse(), std::nullopt); // all of one kind
    const double alone =
        solve_seepage({packing.h, {}}, packing.position, packing.radius, {1, along}, fluid).permeability;
    packing.position.push_back({0.6, 0.7, 0.8});
    packing.radius.push_back(0.1);
    EXPECT_EQ(of_coarse(), alone);
}

TEST(RaisedByFines, AreMeaningfulWhereTheNetworkIsTheSourceAndMoreThanItsGrainsAlone) {
    EXPECT_EQ(words_of({.raised_by_fines = 1.01}, "of the sample"), "");
    EXPECT_EQ(words_of({.solver = Solver::Resolved, .raised_by_fines = 1.2}, "of the sample"), "");
    const std::string words = words_of({.raised_by_fines = 1.2}, "of the sample");
    EXPECT_NE(words.find("of the sample 1.200 times"), std::string::npos);
    EXPECT_NE(words_of({.raised_by_fines = 1.2, .is_limited = true}, "of the sample"), words);
}

TEST(Doubts, AreOfFewFinesLittleFinesAndOfAPermeabilityThatTheyRaise) {
    EXPECT_EQ(doubt_network(mixture_of(50, 2000, 0.2, 0.6), 0.9), Doubt::None);
    EXPECT_EQ(doubt_network(mixture_of(50, 2000, 0.2, 0.6), 1.03), Doubt::RaisedByFines);
    EXPECT_EQ(doubt_network(mixture_of(50, 10, 0.2, 0.6), 0.9), Doubt::FewFines);
    EXPECT_EQ(doubt_network(mixture_of(5000, 100, 0.2, 0.6), 0.9), Doubt::LittleFines);
    EXPECT_EQ(doubt_network(mixture_of(50, 0, 0.2, 0.6), std::nullopt), Doubt::None);
    EXPECT_EQ(doubt_network({0.6, 5, 0.2, 500, 50, 0.03}, 0.9), Doubt::Overlaps);
}

} // namespace
} // namespace suffuse::flow
