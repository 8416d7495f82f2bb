#include "suffuse/flow/water_tile.hpp"

#include "suffuse/flow/throat_edges.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <limits>

namespace suffuse::flow {
namespace {

TEST(WaterTile, HasTheWaterTheDragAndTheSharesOfEachThroatAlone) {
    test::Packing packing = test::random_packing(identity(), 60, 0.03, 0.15, 5);
    for (double& radius : packing.radius) {
        radius *= 1.2; // some overlap
    }
    const pores::PoreNetwork network = pores::build_network(packing.h, packing.position, packing.radius);
    constexpr double least_layer = 1e-9, far = std::numeric_limits<double>::infinity();
    pores::ThroatTile tile;
    pores::ThroatGeometries of;
    WaterTile water;
    std::array<pores::TileRow, 3> to_wall, share;
    to_wall[0].fill(far), to_wall[1].fill(0.16), to_wall[2].fill(far);
    const auto of_throat = [](const std::array<pores::TileRow, 3>& rows, std::size_t t) {
        return std::array<double, 3>{rows[0][t], rows[1][t], rows[2][t]};
    };
    pores::load_throats(network, packing.position, packing.radius, 0, pores::tile_rows, tile);
    pores::measure_throats(tile, of);
    measure_water(tile, of, least_layer, water);
    share_drag(tile, of, to_wall, least_layer, share);
    double twice = 0;
    for (std::size_t t = 0; t < pores::tile_rows; ++t) {
        const std::array<double, 3> wetted = of_throat(of.wetted, t);
        const double volume = of.hydraulic_radius[t] * (wetted[0] + wetted[1] + wetted[2]);
        const ThroatEdges edges(tile.centers(t), tile.pore_1[t], tile.pore_2[t]);
        const ThroatWater once = count_overlaps_once(edges, {volume, {tile.radii(t), wetted}});
        EXPECT_EQ(water.volume[t], once.volume);
        EXPECT_EQ(water.covered_twice[t], once.volume - std::max(0.0, volume));
        twice += water.covered_twice[t];

        const double layer = std::max(least_layer, water_layer(once.grains, once.volume));
        const auto beyond = surface_beyond_wedges(edges, {tile.radii(t), wetted}, 0.8 * layer);
        std::array<double, 3> open{};
        for (std::size_t k = 0; k < 3; ++k) {
            open[k] = std::max(beyond[k], 0.1 * once.grains.area[k]);
        }
        EXPECT_NEAR(water.drag[t] / throat_drag(once.grains, open, layer), 1, 1e-13);

        const WettedGrains grains{tile.radii(t), wetted};
        const auto alone =
            drag_shares(grains, std::max(least_layer, water_layer(grains, volume)), of_throat(to_wall, t));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(share[k][t], alone[k], 1e-14);
        }
    }
    EXPECT_GT(twice, 0); // the case is met
}

} // namespace
} // namespace suffuse::flow
