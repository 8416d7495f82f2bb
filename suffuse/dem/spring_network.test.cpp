#include "suffuse/dem/spring_network.hpp"

#include "suffuse/contact/stress.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::dem {
namespace {

Motions motions_of(const World& world, double phase) {
    Motions motions;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const double a = phase + 1.7 * static_cast<double>(g), per_radius = 1 / world.grains.radius[g];
        motions.shift.push_back({std::sin(a), std::cos(1.3 * a), std::sin(2.1 * a)});
        motions.turn.push_back(per_radius * Vec3{std::cos(a), std::sin(1.9 * a), std::cos(2.3 * a)});
    }
    return motions;
}

Motions applied(const World& world, const Motions& in) {
    const SpringNetwork network(world, world.material.shear_ratio);
    Motions out{std::vector<Vec3>(network.rows()), std::vector<Vec3>(network.rows())};
    network.apply(in, out);
    return out;
}

double product(const World& world, const Motions& a, const Motions& b) {
    double sum = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        sum += dot(a.shift[g], b.shift[g]) + dot(a.turn[g], b.turn[g]);
    }
    return sum;
}

TEST(SpringNetwork, NeedsTheForceOfTheNormalSpringToPressTwoGrainsTogether) {
    const World world = test::two_grains(1e-4, 1.5e-4, 1e-7, {});
    const double kn = contact::normal_stiffness(world.material, 1e-4, 1.5e-4, 0);
    const Motions force = applied(world, {{{}, {-1, 0, 0}}, {{}, {}}});
    EXPECT_NEAR(force.shift[1].x, -kn, 1e-12 * kn);
    EXPECT_NEAR(force.shift[0].x, kn, 1e-12 * kn);
    EXPECT_EQ(force.turn[0], Vec3{});
}

TEST(SpringNetwork, OfAPackingIsSymmetricTakesEnergyAndExertsNoForceAsAWhole) {
    const World world = test::reference_packing("packing500");
    const Motions x = motions_of(world, 0), y = motions_of(world, 0.4), kx = applied(world, x), ky = applied(world, y);
    const double size = product(world, x, kx);
    EXPECT_GT(size, 0);
    EXPECT_NEAR(product(world, y, kx), product(world, x, ky), 1e-10 * size); // rounding over 1,000 contacts
    Vec3 total;
    double largest = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        total += kx.shift[g];
        largest = std::max(largest, norm(kx.shift[g]));
    }
    EXPECT_LE(norm(total), 1e-11 * largest);
}

TEST(SpringNetwork, LetsAPackingMoveAsAWhole) {
    const World world = test::reference_packing("packing500");
    Motions together = motions_of(world, 0);
    const double size = norm(applied(world, together).shift[0]);
    std::fill(together.shift.begin(), together.shift.end(), Vec3{1, -2, 3});
    std::fill(together.turn.begin(), together.turn.end(), Vec3{});
    for (const Vec3& force : applied(world, together).shift) {
        EXPECT_LE(norm(force), 1e-12 * size);
    }
}

} // namespace
} // namespace suffuse::dem
