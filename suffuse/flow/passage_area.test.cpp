#include "suffuse/flow/passage_area.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

namespace suffuse::flow {
namespace {

const Passage graded{0.02, {0.5, 1.1, pi - 1.6}, {1.0, 0.3, 0.55}};

PassageArea by_quadrature(const Passage& passage, double below, double above) {
    constexpr int steps = 400'000; // midpoints: its error is far below 1e-8 of the whole
    double area = 0, inverse = 0;
    for (int i = 0; i < steps; ++i) {
        const double a = passage_area_at(passage, below + (i + 0.5) * (above - below) / steps);
        area += a / steps;
        inverse += 1 / a / steps;
    }
    return {area, 1 / inverse};
}

TEST(PassageArea, IsTheTriangleLessTheSectionsOfItsGrains) {
    const double triangle = 1.3, r = 0.5; // three grains of one size cover half a disk
    const Passage passage{triangle - 0.5 * pi * r * r, {1, 1.2, pi - 2.2}, {r, r, r}};
    for (const double z : {-0.7, -0.3, 0.0, 0.2, 0.5, 2.0}) {
        const double section = 0.5 * pi * std::max(0.0, r * r - z * z);
        EXPECT_NEAR(passage_area_at(passage, z), triangle - section, 1e-15);
    }
}

TEST(PassageArea, HasTheMeansOfAQuadrature) {
    for (const auto& [below, above] : {std::array{-0.2, 0.25}, {-1.4, 0.4}, {0.1, 0.9}, {-2.0, -0.05}, {-0.29, 3.0}}) {
        const PassageArea found = mean_passage_area(graded, below, above, 1e-9);
        const PassageArea slow = by_quadrature(graded, below, above);
        EXPECT_NEAR(found.mean / slow.mean, 1, 1e-8) << below << " " << above;
        EXPECT_NEAR(found.harmonic / slow.harmonic, 1, 1e-8) << below << " " << above;
        const PassageArea turned = mean_passage_area(graded, -above, -below, 1e-9);
        EXPECT_NEAR(turned.harmonic / found.harmonic, 1, 1e-14);
    }
}

TEST(PassageArea, DoesNotDependOnTheOrderOfItsGrains) {
    const PassageArea found = mean_passage_area(graded, -0.4, 0.7, 1e-9);
    const auto& [a, r] = std::pair(graded.angle, graded.radius);
    for (const auto& [i, j, k] : {std::array{0U, 2U, 1U}, {1U, 0U, 2U}, {1U, 2U, 0U}, {2U, 0U, 1U}, {2U, 1U, 0U}}) {
        const PassageArea other =
            mean_passage_area({graded.facet, {a[i], a[j], a[k]}, {r[i], r[j], r[k]}}, -0.4, 0.7, 1e-9);
        EXPECT_NEAR(other.mean / found.mean, 1, 1e-14);
        EXPECT_NEAR(other.harmonic / found.harmonic, 1, 1e-14);
    }
}

TEST(PassageArea, OfAShortWayIsThatHalfway) {
    const double at = passage_area_at(graded, 0.4);
    EXPECT_EQ(mean_passage_area(graded, 0.4, 0.4, 1e-9).harmonic, at);
    EXPECT_NEAR(mean_passage_area(graded, 0.4 - 1e-5, 0.4 + 1e-5, 1e-9).harmonic / at, 1, 1e-8);
    EXPECT_NEAR(mean_passage_area(graded, 0.4 - 1e-5, 0.4 + 1e-5, 1e-9).mean / at, 1, 1e-8);
}

} // namespace
} // namespace suffuse::flow
