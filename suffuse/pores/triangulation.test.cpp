#include "suffuse/pores/triangulation.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/pores/lattice.hpp"
#include "suffuse/pores/part_of_cell.hpp"
#include "suffuse/pores/power_center.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <algorithm>
#include <limits>
#include <set>

namespace suffuse::pores {
namespace {

using test::Packing;

Triangulation triangulate(const Packing& packing) {
    return pores::triangulate(packing.h, packing.position, packing.radius);
}

/// The tetrahedra as sets of grains: what does not depend on images or order.
std::multiset<std::array<std::uint32_t, 4>> grain_sets(const Triangulation& t) {
    std::multiset<std::array<std::uint32_t, 4>> sets;
    for (auto grains : t.grain) {
        std::sort(grains.begin(), grains.end());
        sets.insert(grains);
    }
    return sets;
}

/// Smallest gap between any image of any grain and the tetrahedra: power of the center less that of the tetrahedron,
/// relative to the squared radius. Negative where the triangulation is not a weighted Delaunay one.
double least_clearance(const Packing& packing, const Triangulation& t) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < t.size(); ++p) {
        const auto x = corners_of(t, p, packing.h, packing.position);
        std::array<double, 4> w;
        for (std::size_t k = 0; k < 4; ++k) {
            w[k] = packing.radius[t.grain[p][k]] * packing.radius[t.grain[p][k]];
        }
        const PowerCenter center = power_center(x, w);
        const double power = norm2(center.point - x[0]) - w[0];
        const Mat3 inverse_h = inverse(packing.h);
        for (std::size_t g = 0; g < packing.size(); ++g) {
            const Vec3 s = inverse_h * (center.point - packing.position[g]);
            for (int image = 0; image < 125; ++image) {
                const Vec3 n{
                    std::round(s.x) + image / 25 - 2, std::round(s.y) + image / 5 % 5 - 2,
                    std::round(s.z) + image % 5 - 2};
                const double r = packing.radius[g];
                const double other = norm2(center.point - packing.position[g] - packing.h * n) - r * r;
                least = std::min(least, (other - power) / (r * r));
            }
        }
    }
    return least;
}

Mat3 sheared() {
    return from_columns({1.0, 0.05, 0}, {0.6, 0.9, 0.1}, {-0.3, 0.45, 1.1});
}

TEST(Triangulation, HasAsManyTetrahedraAsTheReference) {
    EXPECT_EQ(triangulate(test::reference_spheres("packing500")).size(), 3045U);
    const Triangulation t = triangulate(test::reference_spheres("packing10k"));
    EXPECT_EQ(t.size(), 61147U);
    EXPECT_TRUE(t.hidden.empty());
    EXPECT_EQ(t.jitter, 0);
}

TEST(Triangulation, NoImageOfAnyGrainIsInConflictWithATetrahedron) {
    const std::vector<Packing> packings = {
        test::random_packing(identity(), 60, 0.05, 0.09, 1), test::random_packing(sheared(), 60, 0.03, 0.12, 2),
        test::random_packing(diagonal({2, 2, 0.3}), 80, 0.04, 0.1, 3), // a flat cell, grains a third of its width wide
        test::random_packing(identity(), 4, 0.2, 0.3, 4), test::random_packing(sheared(), 40, 0.01, 0.3, 5)};
    for (const Packing& packing : packings) {
        const Triangulation t = triangulate(packing);
        EXPECT_EQ(find_defect(t, packing.h, packing.position), std::nullopt);
        EXPECT_GT(
            least_clearance(packing, t), -1e-9
        ); // rounding of the centers; the test sees all images within two periods
    }
}

TEST(Triangulation, HoldsForAnyCellShapeAndNumberOfGrains) {
    const std::vector<Mat3> cells = {identity(), sheared(), diagonal({3, 1, 0.4}), diagonal({0.5, 0.5, 6})};
    for (const Mat3& h : cells) {
        const Vec3 width = cell::widths(h);
        const double narrow = std::min({width.x, width.y, width.z});
        for (const std::size_t grains : {1, 2, 3, 10, 100, 400}) {
            const double spacing = std::cbrt(determinant(h) / static_cast<double>(grains));
            const double r = std::min(0.3 * spacing, 0.45 * narrow);
            const Packing packing = test::random_packing(h, grains, 0.5 * r, r, static_cast<unsigned>(grains));
            EXPECT_EQ(find_defect(triangulate(packing), packing.h, packing.position), std::nullopt) << grains;
        }
    }
}

TEST(Triangulation, SameWhateverBasisDescribesTheCell) {
    const Packing packing = test::random_packing(identity(), 150, 0.04, 0.1, 7);
    Packing other = packing;
    other.h = packing.h * Mat3{{{{1, 3, -2}, {0, 1, 5}, {0, 0, 1}}}};
    EXPECT_EQ(grain_sets(triangulate(packing)), grain_sets(triangulate(other)));
    EXPECT_EQ(find_defect(triangulate(other), other.h, other.position), std::nullopt);
}

TEST(Triangulation, SameWhereverTheGrainsAreInTheirPeriods) {
    const Packing packing = test::random_packing(sheared(), 150, 0.04, 0.1, 8);
    Packing other = packing;
    for (std::size_t g = 0; g < other.size(); ++g) {
        const auto n = static_cast<std::int32_t>(g % 7);
        other.position[g] += cell::shift(packing.h, {n - 3, 2 - n, n % 3});
    }
    EXPECT_EQ(grain_sets(triangulate(packing)), grain_sets(triangulate(other)));
}

TEST(Triangulation, SameInAnyNumberOfPartsAndThreads) {
    const std::vector<Packing> packings = {
        test::reference_spheres("packing2000"), test::random_packing(sheared(), 400, 0.02, 0.08, 13),
        test::random_packing(diagonal({3, 1, 0.4}), 200, 0.03, 0.1, 14), test::face_centered(4, 0.3),
        test::simple_cubic(5, 1e-4)};
    for (const Packing& packing : packings) {
        const Triangulation whole = pores::triangulate(packing.h, packing.position, packing.radius, 1);
        for (const int parts : {2, 8, 64}) {
            set_thread_count(parts == 8 ? 3 : 1);
            const Triangulation cut = pores::triangulate(packing.h, packing.position, packing.radius, parts);
            EXPECT_EQ(cut.grain, whole.grain);
            EXPECT_EQ(cut.grain_image, whole.grain_image);
            EXPECT_EQ(cut.neighbor, whole.neighbor);
            EXPECT_EQ(cut.neighbor_image, whole.neighbor_image);
            EXPECT_EQ(cut.jitter, 0);
        }
    }
    set_thread_count(1);
}

TEST(Triangulation, PartsMayBeEmpty) {
    Packing corner = test::random_packing(identity(), 30, 0.01, 0.02, 15);
    for (Vec3& x : corner.position) {
        x *= 0.2;
    }
    const Triangulation whole = pores::triangulate(corner.h, corner.position, corner.radius, 1);
    const Triangulation cut = pores::triangulate(corner.h, corner.position, corner.radius, 64);
    EXPECT_EQ(cut.grain, whole.grain);
    EXPECT_EQ(cut.neighbor, whole.neighbor);
}

TEST(Triangulation, TakesMoreImagesWhereATetrahedronIsMissing) {
    const Packing packing = test::reference_spheres("moved_fines");
    const ExactPacking exact = exact_packing(packing.h, packing.position, packing.radius);
    const std::size_t of_few = triangulate_part(exact, {1, 1, 1}, {0, 0, 0}, Care::Kept).corner.size();
    for (const int parts : {1, 4}) {
        const Triangulation t = pores::triangulate(packing.h, packing.position, packing.radius, parts);
        EXPECT_GT(t.size(), of_few);
        EXPECT_EQ(t.jitter, 0);
        EXPECT_EQ(find_defect(t, packing.h, packing.position), std::nullopt);
    }
}

TEST(Triangulation, SameAtAnyScale) {
    const Packing packing = test::random_packing(sheared(), 150, 0.04, 0.1, 9);
    const auto sets = grain_sets(triangulate(packing));
    for (const double factor : {1e-6, 1e-3, 1e3}) {
        Packing scaled = packing;
        scaled.h = factor * packing.h;
        for (std::size_t g = 0; g < packing.size(); ++g) {
            scaled.position[g] *= factor;
            scaled.radius[g] *= factor;
        }
        EXPECT_EQ(grain_sets(triangulate(scaled)), sets);
    }
}

TEST(Triangulation, LatticesNeedNoJitter) {
    for (const Packing& packing :
         {test::simple_cubic(1, 0.5), test::simple_cubic(4, 1e-4), test::body_centered(3, 1e-4),
          test::face_centered(3, 0.3)}) {
        const Triangulation t = triangulate(packing);
        EXPECT_EQ(find_defect(t, packing.h, packing.position), std::nullopt);
        EXPECT_EQ(t.jitter, 0);
    }
}

TEST(Triangulation, RotatedLatticeHolds) {
    // Nothing is aligned with the axes here: cospherical grains differ from it by rounding only.
    const Packing straight = test::face_centered(3, 1e-3);
    const double c = std::cos(0.3), s = std::sin(0.3);
    const Mat3 turn = Mat3{{{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}}} * Mat3{{{{1, 0, 0}, {0, c, s}, {0, -s, c}}}};
    Packing turned = straight;
    turned.h = turn * straight.h;
    for (Vec3& x : turned.position) {
        x = turn * x;
    }
    EXPECT_EQ(find_defect(triangulate(turned), turned.h, turned.position), std::nullopt);
}

TEST(Triangulation, DilutedLatticesHold) {
    // Many grains on one sphere, in many places, none of them alike.
    for (const Packing& full :
         {test::simple_cubic(4, 0.5), test::body_centered(3, 1e-4), test::face_centered(2, 1),
          test::face_centered(3, 1)}) {
        for (std::size_t seed = 1; seed <= 10; ++seed) {
            Packing packing;
            packing.h = full.h;
            for (std::size_t g = 0; g < full.size(); ++g) {
                if ((g * 7919 + seed * 104729) % 13 < 4) {
                    continue;
                }
                packing.position.push_back(full.position[g]);
                packing.radius.push_back(full.radius[g]);
            }
            const Triangulation t = triangulate(packing);
            EXPECT_EQ(find_defect(t, packing.h, packing.position), std::nullopt);
            EXPECT_EQ(t.jitter, 0);
        }
    }
}

TEST(Triangulation, GrainsAtOnePlaceAreHiddenOrSeparatedByJitter) {
    int jittered = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        Packing packing = test::random_packing(identity(), 30, 0.05, 0.1, seed);
        packing.position.push_back(packing.position[3]);
        packing.radius.push_back(packing.radius[3]);
        const Triangulation t = triangulate(packing);
        EXPECT_EQ(find_defect(t, packing.h, packing.position), std::nullopt);
        EXPECT_TRUE(t.jitter > 0 || t.hidden.size() == 1);
        EXPECT_LT(t.jitter, 1e-8); // a billionth of the spacing
        jittered += t.jitter > 0 ? 1 : 0;
    }
    EXPECT_GT(jittered, 0); // images may hide one or the other of the two: the case that jitter is for
}

TEST(Triangulation, CountsGrainsBuriedInOthers) {
    Packing packing = test::random_packing(identity(), 100, 0.05, 0.1, 10);
    packing.position.push_back(packing.position[0] + Vec3{0.01, 0, 0});
    packing.radius.push_back(0.02);
    const Triangulation t = triangulate(packing);
    EXPECT_EQ(t.hidden, std::vector<std::uint32_t>{100});
    EXPECT_EQ(find_defect(t, packing.h, packing.position), std::nullopt);
}

TEST(Triangulation, DefectsAreFound) {
    const Packing packing = test::random_packing(identity(), 50, 0.05, 0.1, 11);
    const Triangulation good = triangulate(packing);
    ASSERT_EQ(find_defect(good, packing.h, packing.position), std::nullopt);
    Triangulation missing = good;
    missing.grain.pop_back();
    EXPECT_NE(find_defect(missing, packing.h, packing.position)->find("add up"), std::string::npos);
    Triangulation torn = good;
    torn.neighbor_image[7][2] = torn.neighbor_image[7][2] + cell::Image{1, 0, 0};
    EXPECT_NE(find_defect(torn, packing.h, packing.position)->find("other side"), std::string::npos);
    Triangulation renamed = good;
    std::vector<Vec3> position = packing.position; // a second name for grain 0: one vertex more, edges more
    position.push_back(position[0]);
    *std::find(renamed.grain[3].begin(), renamed.grain[3].end(), renamed.grain[3][1]) = 50;
    position[50] = packing.position[good.grain[3][1]];
    EXPECT_NE(find_defect(renamed, packing.h, position)->find("Euler"), std::string::npos);
}

TEST(Triangulation, RefusesWhatIsNotAPacking) {
    const Packing good = test::random_packing(identity(), 20, 0.05, 0.1, 12);
    Packing bad = good;
    bad.position[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(triangulate(bad), GeometryError);
    bad = good;
    bad.radius[4] = 0;
    EXPECT_THROW(triangulate(bad), GeometryError);
    bad = good;
    bad.radius[4] = 0.7;
    EXPECT_THROW(triangulate(bad), GeometryError);
    bad = good;
    bad.h = from_columns({1, 0, 0}, {0, 1, 0}, {1, 1, 0});
    EXPECT_THROW(triangulate(bad), GeometryError);
    bad.h = diagonal({1, 1, -1});
    EXPECT_THROW(triangulate(bad), GeometryError);
    bad = good;
    bad.position[0].x = 1e9;
    EXPECT_THROW(triangulate(bad), GeometryError);
    EXPECT_THROW(pores::triangulate(identity(), {}, {}), GeometryError);
}

TEST(CompactBasis, UndoesShears) {
    const Mat3 h = identity() * Mat3{{{{1, 17, -6}, {0, 1, 9}, {0, 0, 1}}}};
    const CompactBasis basis = compact_basis(h);
    for (int b = 0; b < 3; ++b) {
        EXPECT_NEAR(norm(basis.h.column(b)), 1, 1e-12); // whole numbers: exact up to the norm's rounding
    }
    EXPECT_NEAR(determinant(basis.h), 1, 1e-12);
    const cell::Image n{2, -1, 3};
    EXPECT_NEAR(norm(cell::shift(h, basis.original(n)) - cell::shift(basis.h, n)), 0, 1e-12);
}

} // namespace
} // namespace suffuse::pores
