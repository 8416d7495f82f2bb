#include "suffuse/pores/network.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <numeric>

namespace suffuse::pores {
namespace {

using test::Packing;

PoreNetwork build(const Packing& packing) {
    return build_network(packing.h, packing.position, packing.radius);
}

double sum(const std::vector<double>& column) {
    return std::accumulate(column.begin(), column.end(), 0.0);
}

TEST(Network, VolumesAddUpToTheCellAndVoidsToThePorosity) {
    const Packing packing = test::reference_spheres("packing500");
    const PoreNetwork network = build(packing);
    double solid = 0;
    for (const double r : packing.radius) {
        solid += sphere_volume(r);
    }
    const double whole = determinant(packing.h);
    EXPECT_NEAR(sum(network.pores.volume) / whole, 1, 1e-12);
    EXPECT_NEAR(
        sum(network.pores.void_volume) / (whole - solid), 1, 1e-12
    ); // solid angles around a grain add up to 4 pi
}

TEST(Network, ThroatsAreTheFacetsOfBothTheirPores) {
    const Packing packing = test::random_packing(from_columns({1, 0, 0}, {0.4, 1, 0}, {0, -0.3, 1}), 40, 0.05, 0.12, 3);
    const Triangulation triangulation = triangulate(packing.h, packing.position, packing.radius);
    const PoreNetwork network = build(packing);
    const Pores& pores = network.pores;
    const Throats& throats = network.throats;
    ASSERT_EQ(throats.size(), 2 * pores.size());
    std::vector<int> sides(throats.size(), 0);
    for (std::uint32_t p = 0; p < pores.size(); ++p) {
        Vec3 closed;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t t = pores.throat[p][k];
            ++sides[t];
            const std::uint32_t q = triangulation.neighbor[p][k];
            const cell::Image image = triangulation.neighbor_image[p][k];
            const bool is_first = throats.side[t] == std::array{p, q} && throats.image[t] == image;
            const bool is_second = throats.side[t] == std::array{q, p} && throats.image[t] == -image;
            ASSERT_TRUE(is_first || is_second);
            const PlacedPore beyond = pore_beyond(network, p, k);
            EXPECT_EQ(beyond.pore, q);
            EXPECT_EQ(beyond.image, image);
            EXPECT_EQ(corner_beyond(network, p, k), facet_from_other_side(triangulation, p, k));
            closed += (is_first ? 1.0 : -1.0) * throats.area[t];
            // All corners but the opposite one are the throat's.
            const cell::Image move = is_first ? cell::Image{} : throats.image[t];
            const ThroatGrains grains = grains_of(network, t);
            for (std::size_t c = 0; c < 4; ++c) {
                bool found = false;
                for (std::size_t j = 0; j < 3; ++j) {
                    found = found ||
                            (grains.row[j] == pores.grain[p][c] && grains.image[j] == pores.grain_image[p][c] + move);
                }
                EXPECT_EQ(found, c != k);
            }
        }
        EXPECT_NEAR(norm(closed), 0, 1e-14); // facets of a closed body, pointing outwards
    }
    for (const int count : sides) {
        EXPECT_EQ(count, 2);
    }
}

TEST(Network, CentersHaveTheSamePowerToTheirFourGrains) {
    const Packing packing = test::random_packing(identity(), 60, 0.04, 0.12, 4);
    const PoreNetwork network = build(packing);
    for (std::size_t p = 0; p < network.pores.size(); ++p) {
        double first = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t g = network.pores.grain[p][k];
            const Vec3 x = packing.position[g] + shift(packing.h, network.pores.grain_image[p][k]);
            const double power = norm2(network.pores.center[p] - x) - packing.radius[g] * packing.radius[g];
            if (k == 0) {
                first = power;
            }
            EXPECT_NEAR(power, first, 1e-10); // flat tetrahedra amplify rounding
        }
    }
}

TEST(Network, PoresOfCoincidentCentersAreOneBody) {
    // Simple cubic: one void a cube. Face-centered: one octahedron and two tetrahedra a grain. Body-centered: all
    // apart.
    const PoreNetwork cubic = build(test::simple_cubic(3, 1e-4));
    EXPECT_EQ(cubic.bodies, 27U);
    const PoreNetwork face = build(test::face_centered(3, 1e-4));
    EXPECT_EQ(face.bodies, 3U * 108U);
    const PoreNetwork body = build(test::body_centered(3, 1e-4));
    EXPECT_EQ(body.bodies, body.pores.size());
    EXPECT_EQ(build(test::simple_cubic(1, 0.5)).bodies, 1U);
    for (const PoreNetwork* network : {&cubic, &face}) {
        for (std::size_t t = 0; t < network->throats.size(); ++t) {
            const auto [p, q] = network->throats.side[t];
            const Vec3 apart =
                network->pores.center[q] + shift(network->h, network->throats.image[t]) - network->pores.center[p];
            EXPECT_EQ(is_internal(network->throats, t), norm(apart) < 1e-8 * 1e-4);
        }
    }
}

TEST(Network, SameBitsForAnyNumberOfThreads) {
    const Packing packing = test::reference_spheres("packing500");
    const PoreNetwork one = build(packing);
    for (const int threads : {2, 4}) {
        set_thread_count(threads);
        const PoreNetwork many = build(packing);
        set_thread_count(1);
        EXPECT_EQ(one.pores.center, many.pores.center);
        EXPECT_EQ(one.pores.void_volume, many.pores.void_volume);
        EXPECT_EQ(one.throats.hydraulic_radius, many.throats.hydraulic_radius);
        EXPECT_EQ(one.throats.wetted, many.throats.wetted);
    }
}

} // namespace
} // namespace suffuse::pores
