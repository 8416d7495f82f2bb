#include "suffuse/flow/pore_velocity.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/pressure.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <array>
#include <cmath>

namespace suffuse::flow {
namespace {

using test::Packing;

struct Flow {
    pores::PoreNetwork network;
    std::vector<double> flux;
    std::vector<Vec3> velocity;
};

Flow flow_through(const Packing& packing, const Vec3& gradient) {
    Flow flow{pores::build_network(packing.h, packing.position, packing.radius), {}, {}};
    flow.flux = solve_pressure(flow.network, conductances(flow.network, 1e-3), gradient).flux;
    flow.velocity = pore_velocities(flow.network, packing.position, packing.radius, flow.flux);
    return flow;
}

Packing sheared_packing() {
    return test::random_packing(from_columns({1, 0, 0}, {0.5, 1, 0.1}, {-0.2, 0.3, 0.9}), 120, 0.04, 0.1, 5);
}

/// By counting points of a fine grid that lie in the triangle and in none of the three circles.
Vec3 counted_centroid(const std::array<Vec3, 3>& x, const std::array<double, 3>& r) {
    constexpr int steps = 2000;
    Vec3 sum;
    double count = 0;
    for (int i = 0; i < steps; ++i) {
        for (int j = 0; i + j < steps; ++j) {
            const double a = (i + 1.0 / 3) / steps, b = (j + 1.0 / 3) / steps;
            const Vec3 point = x[0] + a * (x[1] - x[0]) + b * (x[2] - x[0]);
            if (norm(point - x[0]) > r[0] && norm(point - x[1]) > r[1] && norm(point - x[2]) > r[2]) {
                sum += point;
                count += 1;
            }
        }
    }
    return sum / count;
}

TEST(VoidCentroid, IsThatOfTheRemainderUnlessAlmostNothingRemains) {
    // Two grains of radius 1 that touch, and a small one between them: it closes 93 % of the triangle, or nearly all.
    const auto centers = [](double height) { return std::array<Vec3, 3>{Vec3{}, Vec3{2, 0, 0}, Vec3{1, height, 0}}; };
    const std::array<double, 3> radius{1, 1, 0.3};
    const std::array<Vec3, 3> open = centers(0.83);
    EXPECT_LE(norm(void_centroid(open, radius) - counted_centroid(open, radius)), 2e-3);
    EXPECT_GT(norm(void_centroid(open, radius) - (1.0 / 3) * (open[0] + open[1] + open[2])), 0.02);
    const std::array<Vec3, 3> closed = centers(0.70);
    EXPECT_EQ(void_centroid(closed, radius), (1.0 / 3) * (closed[0] + closed[1] + closed[2]));
}

TEST(PoreVelocity, AddsUpToTheMeanVelocityInACellOfAnyShape) {
    const Flow flow = flow_through(sheared_packing(), {300, -200, 100});
    const pores::Pores& pores = flow.network.pores;
    Vec3 sum;
    for (std::size_t p = 0; p < pores.size(); ++p) {
        sum += pores.void_volume[p] * flow.velocity[p];
    }
    const Vec3 mean = determinant(flow.network.h) * mean_velocity(flow.network, flow.flux);
    EXPECT_LE(norm(sum - mean), 1e-12 * norm(mean));
}

TEST(PoreVelocity, OfWaterThatFlowsEverywhereTheSameIsItsOwnInEveryPore) {
    // Between points as good as without size a uniform flow passes each facet whole, through its centroid.
    Packing points = sheared_packing();
    points.radius.assign(points.size(), 1e-9);
    const pores::PoreNetwork network = pores::build_network(points.h, points.position, points.radius);
    const Vec3 uniform{0.3, -0.1, 0.2};
    std::vector<double> flux;
    for (const Vec3& area : network.throats.area) {
        flux.push_back(dot(area, uniform));
    }
    const std::vector<Vec3> velocity = pore_velocities(network, points.position, points.radius, flux);
    for (std::size_t p = 0; p < velocity.size(); ++p) {
        const double size = std::cbrt(network.pores.volume[p]); // slivers amplify rounding
        EXPECT_LE(norm(velocity[p] - uniform), 1e-13 / (size * size * size)) << p;
    }
    EXPECT_NEAR(tortuosity(network, velocity), 1, 1e-9);
}

TEST(PoreVelocity, BetweenTheGrainsOfACubicLatticeIsTheMeanOverThePorosity) {
    // Every void sees the same flow: in through one window, out through the opposite one.
    const Packing packing = test::simple_cubic(3, 0.5);
    const Flow flow = flow_through(packing, {2, 0, 0});
    const double porosity = 1 - pi / 6;
    const Vec3 expected = mean_velocity(flow.network, flow.flux) / porosity;
    for (const Vec3& velocity : flow.velocity) {
        EXPECT_LE(norm(velocity - expected), 1e-9 * norm(expected));
    }
    EXPECT_NEAR(tortuosity(flow.network, flow.velocity), 1, 1e-9);
}

TEST(PoreVelocity, TurnsWithTheFlowAndItsTortuosityDoesNot) {
    const Flow along = flow_through(sheared_packing(), {1, 0, 0}), back = flow_through(sheared_packing(), {-10, 0, 0});
    for (std::size_t p = 0; p < along.velocity.size(); ++p) {
        EXPECT_LE(norm(back.velocity[p] + 10.0 * along.velocity[p]), 1e-9 * norm(back.velocity[p]) + 1e-15);
    }
    const double winding = tortuosity(along.network, along.velocity);
    EXPECT_NEAR(tortuosity(back.network, back.velocity), winding, 1e-9);
    EXPECT_GT(winding, 1.05);
    EXPECT_LT(winding, 2);
}

TEST(PoreVelocity, OfWaterAtRestIsZeroAndItsTortuosityUnknown) {
    const Packing packing = sheared_packing();
    const pores::PoreNetwork network = pores::build_network(packing.h, packing.position, packing.radius);
    const std::vector<double> still(network.throats.size(), 0);
    const std::vector<Vec3> velocity = pore_velocities(network, packing.position, packing.radius, still);
    EXPECT_EQ(velocity.front(), Vec3{});
    EXPECT_TRUE(std::isnan(tortuosity(network, velocity)));
    EXPECT_THROW(pore_velocities(network, packing.position, packing.radius, {}), Bug);
}

} // namespace
} // namespace suffuse::flow
