#include "suffuse/pores/locate.hpp"

#include "suffuse/pores/triangulation_check.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <random>

namespace suffuse::pores {
namespace {

TEST(PoreLocator, FindsTheTetrahedronOfAnyPoint) {
    const std::vector<test::Packing> packings = {
        test::reference_spheres("packing500"),
        test::random_packing(from_columns({1, 0, 0}, {0.7, 0.8, 0}, {0, -0.5, 1}), 5, 0.1, 0.2, 2),
        test::simple_cubic(1, 0.5), test::random_packing(diagonal({4, 4, 0.5}), 100, 0.1, 0.2, 3)};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.5, 2.5);
    for (const test::Packing& packing : packings) {
        const PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
        const PoreLocator locator(network, packing.position);
        for (int sample = 0; sample < 300; ++sample) {
            const Vec3 point = packing.h * Vec3{uniform(random), uniform(random), uniform(random)};
            const PoreLocator::Place place = locator.find(point);
            std::array<Vec3, 4> x;
            for (std::size_t k = 0; k < 4; ++k) {
                x[k] = packing.position[network.pores.grain[place.pore][k]] +
                       shift(packing.h, network.pores.grain_image[place.pore][k]) + cell::shift(packing.h, place.image);
            }
            const double whole = tetrahedron_volume(x[0], x[1], x[2], x[3]);
            for (std::size_t k = 0; k < 4; ++k) {
                auto y = x;
                y[k] = point;
                EXPECT_GE(tetrahedron_volume(y[0], y[1], y[2], y[3]) / whole, -1e-9);
            }
        }
    }
}

TEST(PoreLocator, APointMovedByPeriodsLiesInTheSamePoreMovedByThem) {
    const test::Packing packing = test::random_packing(identity(), 20, 0.1, 0.15, 4);
    const PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
    const PoreLocator locator(network, packing.position);
    const auto one = locator.find({0.3, 0.4, 0.5}), moved = locator.find({1.3, -0.6, 0.5});
    EXPECT_EQ(one.pore, moved.pore);
    EXPECT_EQ(moved.image - one.image, (cell::Image{1, -1, 0}));
}

} // namespace
} // namespace suffuse::pores
