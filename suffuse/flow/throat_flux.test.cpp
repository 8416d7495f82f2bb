#include "suffuse/flow/throat_flux.hpp"

#include "suffuse/flow/seepage.hpp"
#include "suffuse/pores/constrictions.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <cmath>
#include <numeric>

namespace suffuse::flow {
namespace {

/// Throats in a row, the k-th (from 1) of diameter k and open; no pores are needed.
pores::PoreNetwork row_of_throats(std::size_t count) {
    pores::PoreNetwork network;
    network.throats.side.resize(count);
    network.throats.length.assign(count, 1);
    network.throats.void_area.assign(count, 1);
    network.throats.hydraulic_radius.assign(count, 1);
    for (std::size_t t = 0; t < count; ++t) {
        network.throats.inscribed_radius.push_back(0.5 * static_cast<double>(t + 1));
    }
    return network;
}

std::vector<double> power_of_size(std::size_t count, double exponent) {
    std::vector<double> flux;
    for (std::size_t t = 0; t < count; ++t) {
        flux.push_back((t % 2 == 0 ? 1 : -1) * std::pow(static_cast<double>(t + 1), exponent)); // either way counts
    }
    return flux;
}

TEST(ThroatFlux, OfFluxesThatGrowWithTheSizeHasItsClosedForm) {
    // Flux x over sizes x evenly spread: its ratio to the mean at a share s is 2 s, the largest s carry 1 - (1 - s)^2,
    // and half goes through 1 - sqrt(1/2). Off by the order of 1/n, for the sizes are counted.
    constexpr std::size_t n = 10'000;
    const ThroatFlux flux = describe_fluxes(row_of_throats(n), power_of_size(n, 1), 0.5);
    EXPECT_EQ(flux.throats, static_cast<std::int64_t>(n));
    EXPECT_NEAR(flux.mean, (n + 1) / 2.0 / 0.5, 1e-9);
    ASSERT_EQ(flux.quantile.size(), 101U);
    for (int k = 0; k <= 100; ++k) {
        const double s = k / 100.0;
        EXPECT_NEAR(flux.quantile[static_cast<std::size_t>(k)], 2 * s, 2e-4);
        EXPECT_NEAR(flux.carried[static_cast<std::size_t>(k)], 1 - (1 - s) * (1 - s), 2e-4);
    }
    EXPECT_NEAR(flux.half_carried_by, 1 - std::sqrt(0.5), 2e-4);
}

TEST(ThroatFlux, OfPoiseuilleTubesUnderOneDropGoesWithTheFourthPowerOfTheSize) {
    constexpr std::size_t n = 24 * 1001; // odd classes: their median is a throat
    const ThroatFlux flux = describe_fluxes(row_of_throats(n), power_of_size(n, 4), 1);
    ASSERT_EQ(flux.diameter.size(), 24U);
    for (std::size_t k = 1; k < flux.diameter.size(); ++k) {
        const double slope =
            std::log(flux.flux_50[k] / flux.flux_50[k - 1]) / std::log(flux.diameter[k] / flux.diameter[k - 1]);
        EXPECT_NEAR(slope, 4, 1e-9); // the median of the fluxes is the flux of the median size, up to rounding
        EXPECT_LT(flux.flux_10[k], flux.flux_50[k]);
        EXPECT_GT(flux.flux_90[k], flux.flux_50[k]);
    }
}

TEST(ThroatFlux, EqualFluxesAreCarriedEvenlyAndWithoutAFlowThereIsNothingToShare) {
    const std::vector<double> even(50, -3), none(50, 0);
    const ThroatFlux flux = describe_fluxes(row_of_throats(50), even, 1);
    EXPECT_DOUBLE_EQ(flux.carried[10], 0.1);
    EXPECT_DOUBLE_EQ(flux.half_carried_by, 0.5);
    EXPECT_EQ(flux.diameter.size(), 2U); // few throats, few classes
    const ThroatFlux still = describe_fluxes(row_of_throats(50), none, 0);
    EXPECT_EQ(still.throats, 50);
    EXPECT_TRUE(still.quantile.empty() && still.carried.empty() && still.diameter.empty());
    EXPECT_EQ(still.mean, 0);
}

TEST(ThroatFlux, ClosedThroatsAndCutsThroughOneBodyOfWaterAreNone) {
    pores::PoreNetwork network = row_of_throats(4);
    network.throats.length[0] = 0;
    network.throats.void_area[1] = 0;
    network.throats.hydraulic_radius[2] = 0;
    EXPECT_EQ(describe_fluxes(network, std::vector<double>{9, 9, 9, 1}, 1).throats, 1);
}

TEST(ThroatFlux, OfAPackingDoesNotDependOnTheGradient) {
    const test::Packing packing = test::reference_spheres("packing500");
    const auto at = [&](double gradient) {
        Seepage seepage = solve_seepage(
            {packing.h, {}}, packing.position, packing.radius,
            {.gradient = gradient, .direction = {0, 0, 1}, .tensor = false}, {}
        );
        pores::measure_constrictions(seepage.network, packing.position, packing.radius);
        return describe_fluxes(seepage.network, seepage.field.flux, gradient);
    };
    const ThroatFlux one = at(1), small = at(0.05);
    EXPECT_NEAR(one.mean / small.mean, 1, 1e-9);
    EXPECT_NEAR(one.half_carried_by, small.half_carried_by, 1.0 / static_cast<double>(one.throats));
    for (std::size_t k = 0; k < one.carried.size(); ++k) {
        EXPECT_NEAR(one.carried[k], small.carried[k], 1e-9);
    }
    EXPECT_GT(one.flux_50.back(), 10 * one.flux_50.front()); // wide throats carry more
}

} // namespace
} // namespace suffuse::flow
