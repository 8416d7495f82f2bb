#include "suffuse/flow/throat_drag.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace suffuse::flow {
namespace {

constexpr double far = std::numeric_limits<double>::infinity(); // no wall

WettedGrains whole_spheres(const std::array<double, 3>& radius) {
    WettedGrains grains{radius, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        grains.area[k] = 4 * pi * radius[k] * radius[k];
    }
    return grains;
}

TEST(WaterLayer, OnWholeSpheresIsAShellOfTheirVolume) {
    const WettedGrains grains = whole_spheres({1e-3, 2e-3, 0.4e-3});
    for (const double h : {1e-9, 1e-5, 1e-3, 1.0}) { // from a film to a thousand radii
        double water = 0;
        for (const double r : grains.radius) {
            water += 4 * pi / 3 * h * (3 * r * r + 3 * r * h + h * h);
        }
        EXPECT_NEAR(water_layer(grains, water) / h, 1, 1e-13);
    }
}

TEST(WaterLayer, IsNothingWithoutWaterOrGrains) {
    EXPECT_EQ(water_layer(whole_spheres({1, 1, 1}), 0), 0);
    EXPECT_EQ(water_layer(whole_spheres({1, 1, 1}), -1), 0);
    EXPECT_EQ(water_layer({{1, 1, 1}, {}}, 1), 0);
}

TEST(ThroatDrag, OfWideWaterIsThatOfLoneSpheres) {
    const std::array<double, 3> r = {1, 2, 5};
    const WettedGrains grains = whole_spheres(r);
    EXPECT_NEAR(throat_drag(grains, grains.area, 1e12) / (6 * pi * (r[0] + r[1] + r[2])), 1, 1e-11);
}

TEST(ThroatDrag, OfAFilmIsItsOpenAreaOverItsThickness) {
    const WettedGrains grains = whole_spheres({1, 2, 5});
    const std::array<double, 3> open = {0.5 * grains.area[0], grains.area[1], 0.1 * grains.area[2]};
    EXPECT_NEAR(throat_drag(grains, open, 1e-12) * 1e-12 / (film * 4 * pi * (0.5 + 4 + 2.5)), 1, 1e-11);
}

TEST(DragShares, FollowDragWhereNoWallIsNear) {
    const WettedGrains grains = whole_spheres({1, 2, 5});
    const auto wide = drag_shares(grains, 1e12, {far, far, far}), narrow = drag_shares(grains, 1e-12, {far, far, far});
    const double radii[] = {1.0 / 8, 2.0 / 8, 5.0 / 8}, areas[] = {1.0 / 30, 4.0 / 30, 25.0 / 30};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(wide[k], radii[k], 1e-11);
        EXPECT_NEAR(narrow[k], areas[k], 1e-11);
    }
}

TEST(DragShares, AtAWallGoToTheGrainsThatHaveNone) {
    const WettedGrains grains = whole_spheres({1, 1, 5});
    const double layer = 2; // a grain feels the water in full at a distance of 3
    const auto away = drag_shares(grains, layer, {3, 3, far}), near = drag_shares(grains, layer, {1.5, 3, far});
    const auto open = drag_shares(grains, layer, {far, far, far});
    EXPECT_EQ(away, open);
    EXPECT_NEAR(near[0], 0.5 * open[0], 1e-15);
    EXPECT_NEAR(near[1] / near[2], open[1] / open[2], 1e-14);
    EXPECT_NEAR(near[0] + near[1] + near[2], 1, 1e-15);
    EXPECT_EQ(drag_shares(grains, layer, {1.5, 1.2, 2}), open); // nobody to take it over
}

TEST(DragShares, OfGrainsThatNoWaterTouchesAreEqual) {
    EXPECT_EQ(drag_shares({{1, 2, 3}, {}}, 1, {far, far, far}), (std::array<double, 3>{1.0 / 3, 1.0 / 3, 1.0 / 3}));
}

} // namespace
} // namespace suffuse::flow
