#include "suffuse/pores/tile.hpp"

#include "suffuse/pores/throat.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"

namespace suffuse::pores {
namespace {

struct Sample {
    test::Packing packing = test::random_packing(identity(), 60, 0.03, 0.15, 5);
    PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
};

TEST(ThroatTile, MeasuresToTheBitsOfOneThroat) {
    const Sample s;
    const std::size_t throats = s.network.throats.size();
    ASSERT_NE(throats % tile_rows, 0U); // the last tile is short
    ThroatTile tile;
    ThroatGeometries of;
    for (std::size_t first = 0; first < throats; first += tile_rows) {
        const std::size_t last = std::min(first + tile_rows, throats);
        load_throats(s.network, s.packing.position, s.packing.radius, first, last, tile);
        measure_throats(tile, of);
        for (std::size_t t = first; t < last; ++t) {
            const ThroatGeometry one = measure_throat(s.network, s.packing.position, s.packing.radius, t);
            const std::size_t k = t - first;
            EXPECT_EQ(of.area[k], one.area);
            EXPECT_EQ(of.void_area[k], one.void_area);
            EXPECT_EQ(of.hydraulic_radius[k], one.hydraulic_radius);
            for (std::size_t j = 0; j < 3; ++j) {
                EXPECT_EQ(of.section[j][k], one.section[j]);
                EXPECT_EQ(of.wetted[j][k], one.wetted[j]);
            }
        }
    }
}

TEST(PoreTile, CoversTheSectorsOfItsSpheres) {
    const Sample s;
    const Pores& pores = s.network.pores;
    const std::size_t last = pores.size(), first = last - 5;
    PoreTile tile;
    TileRow solid;
    load_pores(s.packing.h, pores, s.packing.position, s.packing.radius, first, last, tile);
    measure_solids(tile, solid);
    for (std::size_t p = first; p < last; ++p) {
        EXPECT_NEAR(solid[p - first], pores.volume[p] - pores.void_volume[p], 1e-15);
    }
    EXPECT_EQ(solid[tile_rows - 1], solid[4]); // the last one again
}

} // namespace
} // namespace suffuse::pores
