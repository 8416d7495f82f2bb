#include "suffuse/erosion/water_ways.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace suffuse::erosion {
namespace {

const Vec3 up{0, 0, 1};

dem::World world_of(const test::Packing& packing) {
    dem::World world = test::empty_world(1);
    world.cell.h = packing.h;
    for (std::size_t g = 0; g < packing.size(); ++g) {
        test::add(world, packing.position[g], packing.radius[g]);
    }
    return world;
}

/// How many grains a sphere touches.
int touched(const dem::World& world, const Vec3& x, double radius) {
    const Mat3 inverse_h = inverse(world.cell.h);
    int count = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const Vec3 s = inverse_h * (world.grains.position[g] - x);
        const Vec3 nearest{s.x - std::round(s.x), s.y - std::round(s.y), s.z - std::round(s.z)};
        const double gap = norm(world.cell.h * nearest) - radius - world.grains.radius[g];
        count += std::abs(gap) < 1e-9 * radius ? 1 : 0;
    }
    return count;
}

void expect_straight_ways(const dem::World& world) {
    const WaterWays ways(world, {}, up, {});
    const Vec3 middle{2 * 0.6, 2 * 0.7, 2 * 0.8}; // of a void; windows are 1, 3, 5 ... above it
    const double window = 2 * (std::sqrt(2.0) - 1);
    const Journey small = ways.follow(middle, 0.99 * window, 4, RandomStream(1, "test"));
    EXPECT_FALSE(small.constriction);
    EXPECT_EQ(small.throats, 3);
    EXPECT_NEAR(small.travel, 5, 1e-9);
    EXPECT_NEAR(small.path, 5, 1e-9);
    EXPECT_TRUE(small.places.empty());

    const Journey large = ways.follow(middle, 1.01 * window, 4, RandomStream(1, "test"));
    ASSERT_TRUE(large.constriction);
    EXPECT_NEAR(*large.constriction, window, 1e-9);
    EXPECT_EQ(large.throats, 0);
    EXPECT_NEAR(large.travel, 1, 1e-9);
    EXPECT_TRUE(large.places.empty()) << "it never left its void";
}

TEST(WaterWays, LeadStraightThroughACubicLattice) {
    dem::World world = world_of(test::simple_cubic(3, 1)); // spheres at 0.1, 0.2, 0.3 of cubes of side 2
    expect_straight_ways(world);
    const Mat3& h = world.cell.h; // the same lattice in a cell that leans
    world.cell.h = from_columns(h.column(0), h.column(1) - h.column(0), h.column(2) + h.column(0));
    expect_straight_ways(world);
}

TEST(WaterWays, GrainsGoToThroatsInProportionToTheirFlux) {
    const dem::World world = world_of(test::reference_spheres("packing500"));
    const WaterWays ways(world, {}, up, {});
    const pores::PoreNetwork& network = ways.seepage().network;
    const std::uint32_t pore = 77, body = network.pores.body[pore];
    Vec3 inside; // of the pore's tetrahedron
    for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t g = network.pores.grain[pore][k];
        inside += 0.25 * (world.grains.position[g] + shift(network.h, network.pores.grain_image[pore][k]));
    }
    std::map<double, double> share; // of the outflow, by the throat's diameter
    double outflow = 0;
    for (std::size_t t = 0; t < network.throats.size(); ++t) {
        const double flux = ways.seepage().field.flux[t];
        if (network.pores.body[network.throats.side[t][flux > 0 ? 0 : 1]] == body) {
            share[std::max(0.0, ways.widths()[t])] += std::abs(flux);
            outflow += std::abs(flux);
        }
    }
    ASSERT_GE(share.size(), 2U);
    constexpr int trials = 20'000;
    std::map<double, int> drawn;
    for (int k = 0; k < trials; ++k) { // too large for any throat: held by the first
        const Journey journey = ways.follow(inside, 1, 1, RandomStream(2016, "test", static_cast<std::uint64_t>(k)));
        ++drawn[journey.constriction.value()];
    }
    for (const auto& [diameter, flux] : share) {
        const double p = flux / outflow;
        EXPECT_NEAR(drawn[diameter], trials * p, 1 + 5 * std::sqrt(trials * p * (1 - p))) << diameter;
    }
}

TEST(WaterWays, AGrainIsHeldByWhatIsNarrowerAndLiesInFrontOfIt) {
    const dem::World world = world_of(test::reference_spheres("packing2000"));
    const WaterWays ways(world, {}, up, {});
    const double distance = world.cell.h(2, 2);
    const auto [smallest, largest] = std::minmax_element(world.grains.radius.begin(), world.grains.radius.end());
    int left = 0, held = 0;
    for (int k = 0; k < 400; ++k) {
        RandomStream chance(1, "test", static_cast<std::uint64_t>(k));
        const Vec3 start = world.cell.h * Vec3{chance.uniform(), chance.uniform(), chance.uniform()};
        const double d = *smallest * chance.uniform(0.02, 0.8);
        const Journey journey = ways.follow(start, d, distance, chance);
        if (!journey.constriction) {
            ++left;
            EXPECT_GE(journey.travel, distance);
            EXPECT_LT(journey.travel, distance + 4 * *largest);
            EXPECT_TRUE(journey.places.empty());
        } else {
            held += journey.throats > 0 ? 1 : 0;
            EXPECT_LE(*journey.constriction, d);
            EXPECT_LT(journey.travel, distance);
            ASSERT_EQ(journey.places.size(), journey.throats == 0 ? 0 : std::min(8, journey.throats + 1));
            if (!journey.places.empty()) { // a fourth may be in the way
                EXPECT_GE(touched(world, journey.places.front(), d / 2), 3);
                const Vec3 from_last_throat = journey.places.front() - journey.places[1];
                EXPECT_LT(norm(from_last_throat), 4 * *largest);
            }
        }
        EXPECT_LT(journey.path, (journey.throats + 1) * 4 * *largest) << "no step leads out of its pore";
    }
    EXPECT_GT(left, 20);
    EXPECT_GT(held, 20);
}

TEST(WaterWays, LeadPastTheGrainsThatLeave) {
    dem::World world = world_of(test::simple_cubic(3, 1));
    const Vec3 window{2 * 0.6, 2 * 0.7, 2 * 0.3}; // between four spheres
    const std::uint32_t plug = test::add(world, window, 0.4);
    const Vec3 below = window - Vec3{0, 0, 1};
    const Journey free = WaterWays(world, {&plug, 1}, up, {}).follow(below, 0.5, 1, RandomStream(1, "test"));
    EXPECT_NEAR(free.path, 1, 1e-9) << "straight";
    const Journey around = WaterWays(world, {}, up, {}).follow(below, 0.5, 1, RandomStream(1, "test"));
    EXPECT_GT(around.path, 2) << "by another void";
}

TEST(FollowTheWater, AGrainGoesTheSameWayAgainAndAnotherAtALaterStep) {
    dem::World world = test::reference_packing("packing500");
    std::vector<Traveller> travellers;
    const double most = *std::min_element(world.grains.radius.begin(), world.grains.radius.end());
    for (std::uint32_t k = 0; k < 50; ++k) {
        const Vec3 x = world.cell.h * Vec3{0.02 * k, 0.5, 0.3};
        travellers.push_back({test::add(world, x, 0.05 * most, true), world.cell.h(2, 2)});
    }
    const auto paths = [&] {
        std::vector<double> path;
        for (const Journey& journey : follow_the_water(world, travellers, up, {})) {
            EXPECT_EQ(journey.row, travellers[path.size()].row);
            path.push_back(journey.path);
        }
        return path;
    };
    const std::vector<double> first = paths();
    EXPECT_EQ(paths(), first);
    ++world.clock.step;
    EXPECT_NE(paths(), first);
}

TEST(TouchingPlace, IsThatOfASphereOnThreeOthers) {
    const double height = std::sqrt(1.5 * 1.5 - 4.0 / 3); // on three of radius 1 that touch each other
    const std::array<Vec3, 3> equal = {Vec3{0, 0, 5}, {2, 0, 5}, {1, std::sqrt(3.0), 5}};
    const Vec3 above = touching_place(equal, {1, 1, 1}, 0.5, {0, 0.3, 1});
    EXPECT_NEAR(norm(above - Vec3{1, 1 / std::sqrt(3.0), 5 + height}), 0, 1e-14);
    EXPECT_NEAR(touching_place(equal, {1, 1, 1}, 0.5, -up).z, 5 - height, 1e-14);

    const std::array<Vec3, 3> any = {Vec3{0.1, 0.2, 0.3}, {2.5, 0.1, 0.8}, {0.7, 2.2, -0.4}};
    const std::array<double, 3> radius = {1, 1.3, 0.9};
    const Vec3 x = touching_place(any, radius, 0.6, up);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(norm(x - any[k]), radius[k] + 0.6, 1e-14);
    }
    EXPECT_EQ(touching_place(equal, {1, 1, 1}, 0.01, up).z, 5) << "falls through: in the plane";
}

} // namespace
} // namespace suffuse::erosion
