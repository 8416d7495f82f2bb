#include "suffuse/figures/figures_flux.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::figures {
namespace {

/// Flux as the cube of the size, ten classes; fluxes that all carry alike.
flow::ThroatFlux cubic() {
    flow::ThroatFlux flux;
    flux.throats = 12'000;
    flux.mean = 2.5e-12;
    flux.half_carried_by = 0.125;
    for (int k = 0; k <= 100; ++k) {
        flux.quantile.push_back(k / 50.0);
        flux.carried.push_back(std::sqrt(k / 100.0));
    }
    for (int k = 1; k <= 10; ++k) {
        flux.diameter.push_back(1e-5 * k);
        flux.flux_50.push_back(1e-3 * k * k * k);
        flux.flux_10.push_back(1e-4 * k * k * k);
        flux.flux_90.push_back(1e-2 * k * k * k);
    }
    return flux;
}

TEST(FluxFigures, SizesAreInMillimetersAndTheCaptionHasTheExponent) {
    const auto figure = flux_by_size({{"before erosion", cubic()}, {"after pass 1", cubic()}});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.rows(), 20U);
    EXPECT_DOUBLE_EQ(figure->table.numbers("diameter")[2], 0.03);
    EXPECT_DOUBLE_EQ(figure->table.numbers("flux_over_mean")[2], 0.027);
    EXPECT_EQ(figure->claim, "The flux grows as the power 3 of a throat's size");
    EXPECT_NE(
        figure->caption.find("Before erosion: the median flux grows as the power 3 of the size"), std::string::npos
    ) << figure->caption;
    EXPECT_NE(figure->caption.find("2.5·10⁻¹² m³/s at i = 1; after pass 1"), std::string::npos) << figure->caption;
}

TEST(FluxFigures, SharesAreInPercentAndTheCaptionSaysHowFewCarryTheFlow) {
    const auto figure = flux_shares({{"before erosion", cubic()}});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.rows(), 101U);
    EXPECT_DOUBLE_EQ(figure->table.numbers("share_of_throats")[25], 25);
    EXPECT_DOUBLE_EQ(figure->table.numbers("share_of_flow")[25], 50);
    EXPECT_EQ(figure->claim, "Half of the flow goes through 12 % of the throats");
    EXPECT_NE(
        figure->caption.find(
            "half of the flow goes through 12.5 % of the 12,000 throats, 31.6 % of it through the tenth"
        ),
        std::string::npos
    ) << figure->caption;
}

TEST(FluxFigures, AreNotDrawnWithoutAFlow) {
    EXPECT_FALSE(flux_by_size({}) || flux_shares({}));
    EXPECT_FALSE(flux_by_size({{"still", {}}}) || flux_shares({{"still", {}}}));
}

} // namespace
} // namespace suffuse::figures
