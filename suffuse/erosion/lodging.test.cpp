#include "suffuse/erosion/lodging.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::erosion {
namespace {

const Vec3 corner{1, 1, 1}, middle{5, 5, 5}, edge{5, 5, 9};

/// A cell of edge 10 with grains of radius 0.5 at these places.
dem::World grains_at(const std::vector<Vec3>& places) {
    dem::World world = test::empty_world(10);
    for (const Vec3& x : places) {
        test::add(world, x, 0.5, true);
    }
    return world;
}

Journey held(std::uint32_t row, std::vector<Vec3> places) {
    Journey journey;
    journey.row = row, journey.constriction = 0.9, journey.places = std::move(places);
    return journey;
}

Journey left(std::uint32_t row) {
    Journey journey;
    journey.row = row;
    return journey;
}

TEST(Lodging, TakesTheFirstPlaceThatNobodyFills) {
    const dem::World world = grains_at({corner, middle});
    const auto places = find_places(world, std::vector{held(0, {middle + Vec3{0.9, 0, 0}, edge, corner})});
    EXPECT_EQ(places, (std::vector<std::optional<Vec3>>{edge})); // the first overlaps a grain that stays
    const auto through_the_cell = find_places(world, std::vector{held(0, {middle + Vec3{10.9, 0, -20}, edge})});
    EXPECT_EQ(through_the_cell, (std::vector<std::optional<Vec3>>{edge}));
}

TEST(Lodging, LetsGrainsTouch) {
    const dem::World world = grains_at({corner, middle});
    const Vec3 neighbor = middle + Vec3{1, 0, 0}, deeper = middle + Vec3{0.9999, 0, 0};
    EXPECT_EQ(
        find_places(world, std::vector{held(0, {deeper, neighbor})}), (std::vector<std::optional<Vec3>>{neighbor})
    );
}

TEST(Lodging, AGrainWithoutAFreePlaceStaysWhereItWas) {
    const dem::World world = grains_at({corner, middle, edge});
    const auto places = find_places(world, std::vector{held(0, {middle}), held(1, {}), left(2)});
    EXPECT_EQ(places, (std::vector<std::optional<Vec3>>(3)));
}

TEST(Lodging, TwoGrainsDoNotTakeOnePlace) {
    const Vec3 behind = edge - Vec3{0, 0, 1.5};
    const dem::World world = grains_at({corner, corner + Vec3{2, 0, 0}});
    const auto places = find_places(world, std::vector{held(0, {edge, behind}), held(1, {edge, behind})});
    EXPECT_EQ(places, (std::vector<std::optional<Vec3>>{edge, behind}));
}

TEST(Lodging, APlaceIsFreeAfterItsGrainHasLeftOrMovedOn) {
    const dem::World world = grains_at({corner, middle, edge});
    const auto after_one_left = find_places(world, std::vector{held(0, {middle}), left(1)});
    EXPECT_EQ(after_one_left, (std::vector<std::optional<Vec3>>{middle, std::nullopt}));
    const auto queue = find_places(world, std::vector{held(0, {middle}), held(1, {edge}), left(2)});
    EXPECT_EQ(queue, (std::vector<std::optional<Vec3>>{middle, edge, std::nullopt}));
}

} // namespace
} // namespace suffuse::erosion
