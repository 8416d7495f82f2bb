#include "suffuse/pores/facet_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace suffuse::pores {
namespace {

InscribedCircle
room(const Vec3& b, const Vec3& c, const std::array<double, 3>& r, const std::vector<std::pair<Vec3, double>>& others) {
    NearGrains near;
    for (const auto& [x, own] : others) {
        near.add(x, own);
    }
    const InscribedCircle circle = inscribed_circle(b, c, r);
    return circle.is_inside && is_free(circle, near) ? circle : largest_in_facet(b, c, r, circle, near);
}

TEST(FacetRoom, OfTouchingGrainsIsTheirCircle) {
    const double h = std::sqrt(3.0);
    EXPECT_NEAR(room({2, 0, 0}, {1, h, 0}, {1, 1, 1}, {}).radius, 2 / h - 1, 1e-15);
    EXPECT_NEAR(room({2, 0, 0}, {1, h, 0}, {1, 1, 1}, {{{1, 1 / h, 1.6}, 1}}).radius, 2 / h - 1, 1e-15);
    // Half a square: the center lies on its edge, whichever side of it rounding takes it to.
    for (const double turn : {0.0, 0.3, 1.7, 4.0}) {
        const Vec3 b = 2 * Vec3{std::cos(turn), std::sin(turn), 0}, c = 2 * Vec3{-std::sin(turn), std::cos(turn), 0};
        const InscribedCircle found = room(b, c, {1, 1, 1}, {{b + c, 1}});
        EXPECT_NEAR(found.radius, std::sqrt(2.0) - 1, 1e-14);
        EXPECT_NEAR(norm(found.center - 0.5 * (b + c)), 0, 1e-13);
    }
}

TEST(FacetRoom, BetweenGrainsInARowIsTheWiderGap) {
    // The middle grain all but on the line: the circle that touches all three is as large as one likes.
    for (const double aside : {1e-2, 1e-5, 1e-8}) {
        const Vec3 b{10, 0, 0}, c{4, aside, 0};
        const double circle = inscribed_circle(b, c, {1, 1, 1}).radius;
        EXPECT_TRUE(circle == 0 || circle > 1000) << circle;
        const InscribedCircle found = room(b, c, {1, 1, 1}, {});
        EXPECT_NEAR(found.radius, 2, 2 * aside); // from 4 to 10, less two radii, halved
        EXPECT_NEAR(found.center.x, 7, 2 * aside);
    }
}

TEST(FacetRoom, ACommonTangentIsNoConstriction) {
    // A grain between two others that nearly has both common tangents of these: only a vast circle far away touches
    // all three, and on the side of the tangent that it reaches over none. The room is between it and one of the two.
    for (const double height : {0.01, 0.0149, 0.015, 0.0151}) {
        const Vec3 b{4, 0, 0}, c{2, height, 0};
        const double own = 0.985;
        EXPECT_GT(inscribed_circle(b, c, {1, 1, own}).radius, 60.0);
        const InscribedCircle found = room(b, c, {1, 1, own}, {});
        const double less = own - 1; // s - 1 = |(s - 2, height)| - own
        const double s = (4 + height * height - less * less) / (2 * (2 + less));
        EXPECT_NEAR(found.radius, s - 1, 1e-15);
        EXPECT_NEAR(std::min(found.center.x, 4 - found.center.x), s, 1e-15);
    }
}

TEST(FacetRoom, AFourthGrainCutsTheCircle) {
    const Vec3 b{4, 0, 0}, c{2, 2 * std::sqrt(3.0), 0}, middle{2, 2 / std::sqrt(3.0), 0};
    const double reach = 4 / std::sqrt(3.0); // from the middle to each of the grains
    for (const double above : {0.8, 1.2, 2.0, 2.3}) {
        const Vec3 fourth = middle + Vec3{0, 0, above};
        const InscribedCircle found = room(b, c, {1, 1, 1}, {{fourth, 1}});
        EXPECT_LT(found.radius, reach - 1);
        EXPECT_NEAR(norm(found.center - fourth), found.radius + 1, 1e-13) << "it touches the fourth";
        const double at_edge = std::min(1.0, std::hypot(reach / 2, above) - 1); // what is left in its middle
        EXPECT_GE(found.radius, at_edge - 1e-14);
    }
    EXPECT_NEAR(room(b, c, {1, 1, 1}, {{middle + Vec3{0, 0, reach}, 1}}).radius, reach - 1, 1e-14);
}

TEST(FacetRoom, IsNegativeWhereGrainsFillTheTriangle) {
    EXPECT_LT(room({1, 0, 0}, {0.5, 0.8, 0}, {0.7, 0.7, 0.7}, {}).radius, 0);
    EXPECT_LT(room({1, 0, 0}, {0.4, 0.1, 0}, {0.7, 0.7, 0.7}, {}).radius, 0);
}

/// The largest of the least clearances at places of a fine grid over the triangle.
double searched(
    const Vec3& b, const Vec3& c, const std::array<double, 3>& r, const std::vector<std::pair<Vec3, double>>& others,
    int steps
) {
    double best = -1e300;
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const Vec3 x = (1.0 * i / steps) * b + (1.0 * j / steps) * c;
            double free = std::min({norm(x) - r[0], norm(x - b) - r[1], norm(x - c) - r[2]});
            for (const auto& [place, own] : others) {
                free = std::min(free, norm(x - place) - own);
            }
            best = std::max(best, free);
        }
    }
    return best;
}

TEST(FacetRoom, IsThatOfASlowSearchForAnyGrainsAround) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1), size(0.02, 0.5);
    for (int k = 0; k < 400; ++k) {
        const Vec3 b{2 * any(random), any(random), any(random)}, c{any(random), 2 * any(random), any(random)};
        const std::array<double, 3> r = {size(random), size(random), size(random)};
        std::vector<std::pair<Vec3, double>> others(static_cast<std::size_t>(k % 9));
        for (auto& [x, own] : others) {
            x = any(random) * b + any(random) * c + 1.5 * Vec3{any(random), any(random), any(random)};
            own = size(random);
        }
        const double found = room(b, c, r, others).radius;
        constexpr int steps = 300;
        const double slow = searched(b, c, r, others, steps);
        const double step = std::max({norm(b), norm(c), norm(c - b)}) / steps;
        EXPECT_GE(found, slow - 1e-12) << k;
        EXPECT_LE(found, slow + step) << k; // clearance changes by no more than the distance to the next place
    }
}

} // namespace
} // namespace suffuse::pores
