#include "suffuse/pores/throat.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::pores {
namespace {

TEST(SolidAngle, OctantIsAnEighthOfTheSphere) {
    EXPECT_NEAR(solid_angle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}), pi / 2, 1e-15);
    EXPECT_NEAR(solid_angle({0, 2, 0}, {1, 0, 0}, {0, 0, 3}), -pi / 2, 1e-15);
}

TEST(InscribedCircle, AmongTouchingGrainsIsDescartes) {
    const double table[][4] = {{1, 1, 1, 0.154701}, {1, 1, 0.5, 0.118034}, {1, 0.5, 0.5, 0.093836},
                               {2, 1, 1, 0.187673}, {3, 2, 1, 0.260870},   {1, 1, 0.2, 0.073350}};
    for (const auto& row : table) {
        const double r0 = row[0], r1 = row[1], r2 = row[2];
        const double a = r0 + r1, b = r0 + r2, c = r1 + r2;
        const double x = (a * a + b * b - c * c) / (2 * a);
        const InscribedCircle circle = inscribed_circle({a, 0, 0}, {x, std::sqrt(b * b - x * x), 0}, {r0, r1, r2});
        const double k = 1 / r0 + 1 / r1 + 1 / r2 + 2 * std::sqrt(1 / (r0 * r1) + 1 / (r1 * r2) + 1 / (r2 * r0));
        EXPECT_NEAR(circle.radius, 1 / k, 1e-14);
        EXPECT_NEAR(circle.radius, row[3], 5.1e-7); // six decimals of the table
    }
}

TEST(InscribedCircle, TouchesAllThreeGrains) {
    const Vec3 b{3, 0.2, 0.5}, c{-0.4, 2.5, 1};
    const std::array<double, 3> r = {0.4, 0.9, 0.2};
    const InscribedCircle circle = inscribed_circle(b, c, r);
    EXPECT_NEAR(norm(circle.center), circle.radius + r[0], 1e-14);
    EXPECT_NEAR(norm(circle.center - b), circle.radius + r[1], 1e-14);
    EXPECT_NEAR(norm(circle.center - c), circle.radius + r[2], 1e-14);
    EXPECT_NEAR(dot(circle.center, cross(b, c)), 0, 1e-13);
}

TEST(InscribedCircle, IsNegativeWhereGrainsFillTheTriangle) {
    EXPECT_LT(inscribed_circle({1, 0, 0}, {0.5, 0.8, 0}, {0.7, 0.7, 0.7}).radius, 0);
}

TEST(Throat, OfTouchingEqualGrainsHasItsClosedForm) {
    // Facet of a face-centered lattice, R = 1: between the centers of a tetrahedron and of an octahedron.
    const std::array<Vec3, 3> x = {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, std::sqrt(3.0), 0}};
    const Vec3 middle{1, 1 / std::sqrt(3.0), 0};
    const double tetrahedron = 1 / std::sqrt(6.0), octahedron = 2 / std::sqrt(6.0);
    const ThroatGeometry throat =
        measure_throat(x, {1, 1, 1}, middle - Vec3{0, 0, tetrahedron}, middle + Vec3{0, 0, octahedron});
    EXPECT_NEAR(throat.void_area, std::sqrt(3.0) - pi / 2, 1e-14);
    EXPECT_NEAR(throat.area.z, std::sqrt(3.0), 1e-14);
    // Each grain of the lattice has 8 tetrahedra with 4 facets each of 3 corners, and 6 octahedra: 32 x 3 / 4 = 24
    // corners.
    EXPECT_NEAR(throat.solid_surface, 3 * 4 * pi / 24, 1e-14);
    const double water = std::sqrt(3.0) * (tetrahedron + octahedron) / 3 - 3 * 4 * pi / 24 / 3;
    EXPECT_NEAR(throat.hydraulic_radius, water / (pi / 2), 1e-14);
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(throat.grain_share(k), 1.0 / 3, 1e-14);
    }
}

TEST(Throat, SharesAddUpToOneUnlessAGrainReachesOverTheOppositeEdge) {
    const std::array<Vec3, 3> x = {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{1, 0.9, 0}};
    const auto shares = [&](double r) {
        const auto throat = measure_throat(x, {0.2, 0.2, r}, {1, 0.3, -0.5}, {1, 0.3, 0.6});
        return throat.grain_share(0) + throat.grain_share(1) + throat.grain_share(2);
    };
    EXPECT_NEAR(shares(0.8), 1, 1e-14);
    const double r = 1, h = 0.9, segment = r * r * std::acos(h / r) - h * std::sqrt(r * r - h * h);
    EXPECT_NEAR(shares(r), 1 + segment / 0.9, 1e-14);
}

} // namespace
} // namespace suffuse::pores
