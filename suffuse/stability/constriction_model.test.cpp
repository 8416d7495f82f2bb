#include "suffuse/stability/constriction_model.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/curve.hpp"
#include "suffuse/stability/gradings_for_tests.hpp"

#include <gtest/gtest.h>

#include <random>

namespace suffuse::stability {
namespace {

using testing::box;
using testing::power_law;
using testing::two_boxes;

TEST(DenseConstriction, IsDescartesCircle) {
    struct Case {
        double a, b, c, expected;
    };

    for (const Case& circles :
         {Case{1, 1, 1, 0.154701}, Case{1, 1, 0.5, 0.118034}, Case{1, 0.5, 0.5, 0.093836}, Case{2, 1, 1, 0.187673},
          Case{3, 2, 1, 0.260870}, Case{1, 1, 0.2, 0.073350}}) {
        EXPECT_NEAR(dense_constriction(circles.a, circles.b, circles.c), circles.expected, 5e-7);
    }
}

TEST(LooseConstriction, OfFourEqualGrainsIsTheSquare) {
    // Void of a square of four quarter circles: D^2 (1 - pi/4).
    EXPECT_NEAR(loose_constriction(2, 2, 2, 2), 2 * std::sqrt(4 / pi - 1), 1e-9);
}

/// Area between four circles in a ring, by placing them: the first at the origin, the third on the x axis.
double void_area_by_coordinates(const double (&r)[4], double diagonal) {
    struct Point {
        double x, y;
    };

    const auto apex = [&](double from_first, double from_third, double side) {
        const double x = (from_first * from_first - from_third * from_third + diagonal * diagonal) / (2 * diagonal);
        return Point{x, side * std::sqrt(std::max(0.0, from_first * from_first - x * x))};
    };
    const Point p[4] = {{0, 0}, apex(r[0] + r[1], r[1] + r[2], -1), {diagonal, 0}, apex(r[0] + r[3], r[3] + r[2], 1)};
    double area = 0;
    for (int k = 0; k < 4; ++k) { // shoelace, and each sector by the turn between its neighbors
        const Point &here = p[k], &next = p[(k + 1) % 4], &last = p[(k + 3) % 4];
        area += (here.x * next.y - next.x * here.y) / 2;
        const double to_next = std::atan2(next.y - here.y, next.x - here.x);
        const double to_last = std::atan2(last.y - here.y, last.x - here.x);
        double turn = std::fmod(to_last - to_next + 4 * pi, 2 * pi);
        area -= r[k] * r[k] * turn / 2;
    }
    return area;
}

TEST(LooseConstriction, IsTheLargestVoidOfAllShapes) {
    for (const auto& d :
         {std::array{1.0, 2.0, 3.0, 4.0}, std::array{1.0, 4.0, 2.0, 3.0}, std::array{1.0, 1.0, 1.0, 5.0},
          std::array{2.0, 2.0, 0.5, 0.5}}) {
        const double r[4] = {d[0] / 2, d[1] / 2, d[2] / 2, d[3] / 2};
        double most = 0;
        for (int k = 0; k <= 20000; ++k) {
            const double low = r[0] + r[2], high = std::min(r[0] + 2 * r[1] + r[2], r[0] + 2 * r[3] + r[2]);
            const double diagonal = low + (high - low) * k / 20000.0;
            const double x2 =
                (std::pow(r[0] + r[1], 2) - std::pow(r[1] + r[2], 2) + diagonal * diagonal) / (2 * diagonal);
            const double x4 =
                (std::pow(r[0] + r[3], 2) - std::pow(r[3] + r[2], 2) + diagonal * diagonal) / (2 * diagonal);
            const double y2 = std::sqrt(std::max(0.0, std::pow(r[0] + r[1], 2) - x2 * x2));
            const double y4 = std::sqrt(std::max(0.0, std::pow(r[0] + r[3], 2) - x4 * x4));
            if (std::hypot(x2 - x4, y2 + y4) >= r[1] + r[3]) { // the second and fourth do not overlap
                most = std::max(most, void_area_by_coordinates(r, diagonal));
            }
        }
        EXPECT_NEAR(loose_constriction(d[0], d[1], d[2], d[3]), std::sqrt(4 * most / pi), 1e-4);
    }
}

TEST(ConstrictionModel, OfEqualGrainsIsOneSizeInEachState) {
    const ConstrictionSizes sizes = model_constrictions(box(1e-3, 1.0000001e-3));
    const double dense = 2 / std::sqrt(3) - 1, loose = std::sqrt(4 / pi - 1);
    EXPECT_NEAR(sizes.densest.at(0.35), dense * 1e-3, 1e-9);
    EXPECT_NEAR(sizes.loosest.at(0.35), loose * 1e-3, 1e-9);
    EXPECT_NEAR(sizes.at(0.35, 0.5), (dense + 0.35 * 0.5 * (loose - dense)) * 1e-3, 1e-9);
}

TEST(ConstrictionModel, AgreesWithDrawingGrainsByTheirSurface) {
    const grains::Grading grading = box(0.5e-3, 4e-3);
    std::mt19937_64 source(1);
    const auto draw = [&] {
        return size_by_surface(grading, (static_cast<double>(source() >> 11) + 0.5) / 9007199254740992.0);
    };
    std::vector<std::pair<double, double>> dense, loose;
    for (int k = 0; k < 20000; ++k) {
        const double a = draw(), b = draw(), c = draw(), d = draw();
        dense.emplace_back(dense_constriction(a, b, c), 1);
        loose.emplace_back(loose_constriction(a, b, c, d), 1);
    }
    const SizeDistribution drawn_dense(dense), drawn_loose(loose);
    const ConstrictionSizes model = model_constrictions(grading);
    // Scatter of a percentile of 20,000 draws: below 1 %; sizes standing for others: 1 %.
    for (const double share : {0.2, 0.35, 0.5, 0.8}) {
        EXPECT_NEAR(model.densest.at(share) / drawn_dense.at(share), 1, 0.02) << share;
        EXPECT_NEAR(model.loosest.at(share) / drawn_loose.at(share), 1, 0.02) << share;
    }
}

TEST(SizeBySurface, OfABoxIsAClosedForm) {
    // Mass uniform in log d, surface as mass/d: 1/d falls linearly with the share.
    for (const double share : {0.0, 0.3, 0.85, 1.0}) {
        EXPECT_NEAR(size_by_surface(box(1e-3, 4e-3), share), 1e-3 / (1 - share * 0.75), 1e-12);
    }
}

TEST(Indraratna, CoversAllDensitiesOrNamesTheOneThatDecides) {
    FinesAgainstConstrictions sizes;
    sizes.fines_d85 = 1.0;
    sizes.densest_d35 = 0.8;
    sizes.loosest_d35 = 1.2;
    const Criterion open = indraratna(sizes, std::nullopt);
    EXPECT_EQ(open.verdict, Verdict::CannotSay);
    EXPECT_NE(open.remark.find("stable above 50 %"), std::string::npos) << open.remark;
    EXPECT_EQ(indraratna(sizes, 0.6).verdict, Verdict::Stable);
    EXPECT_NEAR(*indraratna(sizes, 0.6).value, 0.96, 1e-12);
    EXPECT_EQ(indraratna(sizes, 0.4).verdict, Verdict::Unstable);
    sizes.densest_d35 = 1.1;
    EXPECT_EQ(indraratna(sizes, std::nullopt).verdict, Verdict::Unstable);
    sizes = {0, 0.7, 0.9, 1.0, 0, 0};
    EXPECT_EQ(indraratna(sizes, std::nullopt).verdict, Verdict::Stable);
    EXPECT_FALSE(open.verified);
}

TEST(ConstrictionsAndFines, ShareThatPassesComesFromTheFinesGrading) {
    const grains::Grading grading = two_boxes(0.25);
    const auto sizes = compare_with_constrictions(grading, FineFraction{0.30e-3, 0.25}, 0);
    const ConstrictionSizes model = model_constrictions(coarse_part(grading, 0.30e-3));
    EXPECT_DOUBLE_EQ(sizes.densest_d35, model.at(0.35, 1)) << "the controlling size is that of 35 %";
    EXPECT_DOUBLE_EQ(sizes.loosest_d35, model.at(0.35, 0));
    EXPECT_LT(sizes.densest_d35, sizes.loosest_d35);
    EXPECT_NEAR(sizes.densest_passes, std::clamp(std::log2(sizes.densest_d35 / 0.15e-3), 0.0, 1.0), 1e-9);
    EXPECT_NEAR(sizes.fines_d85, 0.15e-3 / (1 - 0.85 / 2), 1e-9);
}

} // namespace
} // namespace suffuse::stability
