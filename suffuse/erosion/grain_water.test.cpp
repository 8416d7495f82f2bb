#include "suffuse/erosion/grain_water.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <cmath>
#include <random>

namespace suffuse::erosion {
namespace {

constexpr flow::Fluid water_of_test{};
constexpr double without_limit = 1;

/// Coarse grains at random, and four fine ones of two sizes.
dem::World random_world() {
    const test::Packing packing = test::random_packing(diagonal({4e-3, 4e-3, 4e-3}), 60, 0.4e-3, 0.5e-3, 3);
    dem::World world;
    world.cell.h = packing.h;
    for (std::size_t g = 0; g < packing.size(); ++g) {
        add_grain(world.grains, packing.position[g], packing.radius[g], world.material.density);
    }
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> anywhere(0, 4e-3);
    for (int fine = 0; fine < 4;) {
        const Vec3 place{anywhere(random), anywhere(random), anywhere(random)};
        const double radius = fine % 2 == 0 ? 0.03e-3 : 0.06e-3;
        bool is_free = true;
        for (std::size_t g = 0; is_free && g < packing.size(); ++g) {
            for (int image = 0; image < 27; ++image) {
                const Vec3 n{image / 9 - 1.0, image / 3 % 3 - 1.0, image % 3 - 1.0};
                is_free = is_free && norm(place - packing.position[g] - packing.h * n) > packing.radius[g] + radius;
            }
        }
        if (is_free) {
            world.grains.fine[add_grain(world.grains, place, radius, world.material.density)] = 1;
            ++fine;
        }
    }
    return world;
}

TEST(GrainWater, FlowsAmongTheGrainsThatStandAlone) {
    const dem::World world = random_world();
    const std::size_t all = world.grains.size();
    std::vector<std::uint8_t> goes(all, 0);
    const GrainWater with(world, goes, {0, 0, 1}, water_of_test, without_limit);
    std::fill(goes.end() - 4, goes.end(), std::uint8_t{1});
    const GrainWater without(world, goes, {0, 0, 1}, water_of_test, without_limit);
    const std::span<const Vec3> position(world.grains.position);
    const std::span<const double> radius(world.grains.radius);
    const flow::FlowSpec unit{.gradient = 1, .direction = {0, 0, 1}};
    EXPECT_EQ(with.permeability(), flow::solve_seepage(world.cell, position, radius, unit, {}).permeability);
    EXPECT_EQ(
        without.permeability(),
        flow::solve_seepage(world.cell, position.first(all - 4), radius.first(all - 4), unit, {}).permeability
    );
    EXPECT_NE(with.permeability(), without.permeability());
    EXPECT_EQ(without.hindrance(), 1) << "no fine grain stands";
}

TEST(GrainWater, IsNoQuickerThanThatOfTheCoarseGrainsAloneAndPushesAsHard) {
    const dem::World world = random_world();
    const std::vector<std::uint8_t> goes(world.grains.size(), 0);
    const GrainWater free(world, goes, {0, 0, 1}, water_of_test, without_limit);
    const GrainWater limited(world, goes, {0, 0, 1}, water_of_test, free.permeability() / 1.25);
    EXPECT_NEAR(free.permeability() / limited.permeability(), 1.25, 1e-12);
    const Vec3 place = world.grains.position.back();
    EXPECT_NEAR(norm(free.velocity_at(place)) / norm(limited.velocity_at(place)), 1.25, 1e-12);
    for (std::uint32_t g = 0; g < world.grains.size(); ++g) {
        EXPECT_EQ(limited.force(g), free.force(g));
        const Vec3 push = world.grains.mass[g] * limited.rate(g) * limited.velocity(g);
        EXPECT_LE(norm(push - limited.force(g)), 1e-12 * norm(push));
    }
}

TEST(GrainWater, DragsAGrainThatGoesWithItByASquareOfItsSizeLess) {
    const dem::World world = random_world();
    const std::size_t all = world.grains.size();
    std::vector<std::uint8_t> goes(all, 0);
    std::fill(goes.end() - 2, goes.end(), std::uint8_t{1}); // one of each size
    const GrainWater water(world, goes, {1, 0, 0}, water_of_test, without_limit);
    const auto small = static_cast<std::uint32_t>(all - 2), large = static_cast<std::uint32_t>(all - 1);
    EXPECT_NEAR(water.rate(small) / water.rate(large), 4, 1e-12);
    const double stokes = 18 * water_of_test.viscosity / (world.material.density * 0.06e-3 * 0.06e-3);
    EXPECT_NEAR(water.rate(small) / (water.hindrance() * stokes), 1, 1e-12);
    for (std::size_t g = all - 4; g < all - 2; ++g) { // those that stand
        const auto row = static_cast<std::uint32_t>(g);
        const double slowest = stokes_rate(2 * world.grains.radius[g], world.grains.mass[g], water_of_test.viscosity);
        EXPECT_GE(water.rate(row), slowest * (1 - 1e-12));
        const Vec3 force = world.grains.mass[g] * water.rate(row) * water.velocity(row);
        EXPECT_LE(norm(force - water.force(row)), 1e-12 * norm(force)) << "a grain at rest feels the flow's force";
    }
}

TEST(GrainWater, OfManyPlacesGoesAtDarcysVelocityOverThePorosity) {
    const dem::World world = random_world();
    const std::vector<std::uint8_t> goes(world.grains.size(), 0);
    const GrainWater water(world, goes, {0, 0, 1}, water_of_test, without_limit);
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(0, 4e-3);
    Vec3 sum;
    double in_water = 0;
    constexpr int points = 40'000;
    for (int k = 0; k < points; ++k) {
        const Vec3 place{anywhere(random), anywhere(random), anywhere(random)};
        bool is_free = true;
        for (std::size_t g = 0; is_free && g < world.grains.size(); ++g) {
            Vec3 apart = place - world.grains.position[g];
            for (int axis = 0; axis < 3; ++axis) {
                apart[axis] -= 4e-3 * std::round(apart[axis] / 4e-3);
            }
            is_free = norm(apart) > world.grains.radius[g];
        }
        if (is_free) {
            sum += water.velocity_at(place);
            in_water += 1;
        }
    }
    const double darcy = water.permeability() * water_of_test.density * gravity / water_of_test.viscosity;
    EXPECT_NEAR(sum.z / in_water / (darcy / (in_water / points)), 1, 0.03); // 40,000 points: 1 %
}

} // namespace
} // namespace suffuse::erosion
