#include "suffuse/neighbors/pairs.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace suffuse::neighbors {
namespace {

struct Cloud {
    Mat3 h;
    std::vector<Vec3> position;
    std::vector<double> radius;
};

/// Radii log-uniform over the size ratio, positions anywhere within two periods of the cell.
Cloud random_cloud(double size_ratio, int grains, const Mat3& h, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Cloud cloud{h, {}, {}};
    for (int g = 0; g < grains; ++g) {
        cloud.radius.push_back(0.12 * std::pow(size_ratio, -uniform(generator)));
        const Vec3 fraction{3 * uniform(generator) - 1, 3 * uniform(generator) - 1, 3 * uniform(generator) - 1};
        cloud.position.push_back(h * fraction);
    }
    return cloud;
}

const Mat3 sheared = {{{{1.0, 0.4, -0.2}, {0.05, 1.3, 0.3}, {0.0, -0.1, 0.8}}}};

class AnySizeRatio : public testing::TestWithParam<double> {};

TEST_P(AnySizeRatio, FindsExactlyThePairsOfTheExhaustiveSearch) {
    for (const Mat3& h : {identity(), sheared}) {
        const Cloud cloud = random_cloud(GetParam(), 700, h, 7);
        const auto found = find_pairs(cloud.h, cloud.position, cloud.radius, 0.01);
        const auto wanted = find_pairs_exhaustively(cloud.h, cloud.position, cloud.radius, 0.01);
        EXPECT_GT(wanted.size(), 100U);
        EXPECT_EQ(found, wanted);
    }
}

TEST_P(AnySizeRatio, FindsExactlyThePairsOfTheGrainsThatAreSought) {
    const Cloud cloud = random_cloud(GetParam(), 700, sheared, 7);
    std::vector<std::uint8_t> sought(cloud.radius.size());
    for (std::size_t g = 0; g < sought.size(); ++g) {
        sought[g] = g % 5 == 0 ? 1 : 0; // of every size
    }
    auto wanted = find_pairs(cloud.h, cloud.position, cloud.radius, 0.01);
    const auto all = wanted.size();
    std::erase_if(wanted, [&](const Pair& pair) { return sought[pair.first] == 0 && sought[pair.second] == 0; });
    EXPECT_LT(wanted.size(), all);
    EXPECT_EQ(find_pairs_of(sought, cloud.h, cloud.position, cloud.radius, 0.01), wanted);
}

INSTANTIATE_TEST_SUITE_P(Pairs, AnySizeRatio, testing::Values(1.0, 4.0, 20.0, 100.0));

TEST(Pairs, AGrainMeetsItsOwnImageInANarrowCell) {
    const std::vector<Vec3> position{{0.1, 0.2, 0.3}};
    const std::vector<double> radius{0.5};
    const auto pairs = find_pairs(identity(), position, radius, 0.01);
    ASSERT_EQ(pairs.size(), 3U); // one along each axis, each counted once
    EXPECT_EQ(pairs, find_pairs_exhaustively(identity(), position, radius, 0.01));
}

TEST(Pairs, SeveralImagesOfOnePairAreAllFound) {
    const std::vector<Vec3> position{{0, 0, 0}, {0.5, 0, 0}};
    const std::vector<double> radius{0.25, 0.25};
    const auto pairs = find_pairs(identity(), position, radius, 1e-6);
    EXPECT_EQ(pairs.size(), 2U); // to the left and to the right
}

TEST(Pairs, OnTheFacesOfTheCellNoneIsLostToRounding) {
    constexpr int edge = 5; // grains along each axis of a lattice whose first layer lies on a face of the cell
    for (const double layer : {0.0, -1e-20, 1e-20, -5e-17, 5e-17, 1 - 0x1p-53, 1 - 0x1p-52}) {
        std::vector<Vec3> position;
        for (int k = 0; k < edge * edge * edge; ++k) {
            const Vec3 place{k % edge * 0.2, k / edge % edge * 0.2, k / (edge * edge) * 0.2};
            position.push_back({place.x == 0 ? layer : place.x, place.y, place.z});
        }
        const std::vector<double> radius(position.size(), 0.1 + 1e-9);
        const auto pairs = find_pairs(identity(), position, radius, 0);
        EXPECT_EQ(pairs.size(), 3U * position.size()) << layer;
        EXPECT_EQ(pairs, find_pairs_exhaustively(identity(), position, radius, 0)) << layer;
    }
}

TEST(Pairs, APositionFarOutIsNotTakenForOneThatIsNotFinite) {
    const std::vector<Vec3> position{{1e300, 0, 0}};
    const std::vector<double> radius{0.25};
    try {
        find_pairs(identity(), position, radius, 0);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string(error.what()).find("wrap the positions"), std::string::npos) << error.what();
    }
}

TEST(Pairs, PositionsThatAreNotFiniteAreAnError) {
    const std::vector<Vec3> position{{0, 0, std::nan("")}};
    const std::vector<double> radius{0.25};
    EXPECT_THROW(find_pairs(identity(), position, radius, 0), GeometryError);
}

} // namespace
} // namespace suffuse::neighbors
