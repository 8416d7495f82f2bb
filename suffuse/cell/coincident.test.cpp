#include "suffuse/cell/coincident.hpp"

#include <gtest/gtest.h>

namespace suffuse::cell {
namespace {

using Rows = std::pair<std::size_t, std::size_t>;

TEST(Coincident, GrainsInOnePlaceAreFoundInAnyImage) {
    const Mat3 h = from_columns({1, 0.2, 0}, {0.3, 0.8, 0}, {0, 0.1, 1.2});
    const std::vector<double> radius = {0.1, 0.2, 0.05, 0.1};
    std::vector<Vec3> position = {{0, 0, 0}, {0.3, 0.4, 0.5}, {0.6, 0.1, 0.9}, {0.3, 0.1, 0}};
    EXPECT_EQ(find_coincident(h, position, radius), std::nullopt);
    for (const Image& image : {Image{}, Image{1, 0, 0}, Image{-3, 2, 7}}) {
        for (std::size_t g = 0; g < 3; ++g) {
            position[3] = position[g] + shift(h, image) + Vec3{1e-9, -1e-9, 1e-9}; // rounding of who wrote it
            EXPECT_EQ(find_coincident(h, position, radius), (Rows{g, 3}));
        }
    }
    position[3] = position[2] + Vec3{1e-6, 0, 0};
    EXPECT_EQ(find_coincident(h, position, radius), std::nullopt);
}

TEST(Coincident, APlaneOfGrainsAcrossTheCellIsSearchedAsAny) {
    std::vector<Vec3> position;
    for (int i = 0; i < 40; ++i) {
        for (int j = 0; j < 40; ++j) {
            position.push_back({0, 0.025 * i, 0.025 * j});
        }
    }
    const std::vector<double> radius(position.size(), 0.01);
    EXPECT_EQ(find_coincident(identity(), position, radius), std::nullopt);
    position[1599] = position[800] + Vec3{1, 0, -1};
    EXPECT_EQ(find_coincident(identity(), position, radius), (Rows{800, 1599}));
    EXPECT_EQ(find_coincident(identity(), {position.data(), 1}, {radius.data(), 1}), std::nullopt);
}

/// Grains a step apart along the cell, in slabs of many and in many slabs: the pair may lie on both sides of any
/// border.
TEST(Coincident, APairIsFoundWhereverItLiesAlongTheCell) {
    constexpr std::size_t count = 20'000;
    std::vector<Vec3> position;
    for (std::size_t g = 0; g < count; ++g) {
        position.push_back({(static_cast<double>(g) + 0.5) / count, 0.3, 0.7});
    }
    const std::vector<double> radius(count, 1e-4);
    EXPECT_EQ(find_coincident(identity(), position, radius), std::nullopt);
    constexpr std::size_t slabs = count / 64 + 1;
    constexpr double slab = 1.0 / slabs;
    for (const double border : {0.0, slab, 64 * slab, 0.5}) {
        std::vector<Vec3> with_pair = position;
        with_pair[70].x = border - 1e-12;
        with_pair[19'000].x = border + 1e-12;
        EXPECT_EQ(find_coincident(identity(), with_pair, radius), (Rows{70, 19'000})) << border;
    }
}

} // namespace
} // namespace suffuse::cell
