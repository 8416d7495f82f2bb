#include "suffuse/pores/voids.hpp"

#include "suffuse/pores/constrictions.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::pores {
namespace {

using test::Packing;

Constrictions constrictions(const Packing& packing, VoidMerge merge) {
    return find_constrictions(packing.h, packing.position, packing.radius, merge);
}

/// Constrictions of equal size, so many of them for each grain.
void expect_constrictions(const Packing& packing, VoidMerge merge, std::size_t per_grain, double radius) {
    const Constrictions found = constrictions(packing, merge);
    EXPECT_EQ(found.diameter.size(), per_grain * packing.size());
    for (const double d : found.diameter) {
        EXPECT_NEAR(d, 2 * radius, 1e-12); // rounding
    }
}

TEST(VoidSphere, IsTheOneThatTheFourGrainsWerePlacedAround) {
    const Vec3 center{0.3, -0.2, 0.7};
    const std::array<Vec3, 4> direction = {{{1, 0.1, 0.2}, {-0.5, 1, 0}, {-0.4, -0.8, 0.3}, {0.1, -0.2, -1}}};
    const std::array<double, 4> r = {1, 0.4, 0.7, 2};
    for (const double size : {0.02, 0.3, 5.0}) {
        std::array<Vec3, 4> x;
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = center + ((size + r[k]) / norm(direction[k])) * direction[k];
        }
        const VoidSphere found = void_sphere(x, r);
        EXPECT_NEAR(found.radius, size, 1e-13 * (1 + size));
        EXPECT_NEAR(norm(found.center - center), 0, 1e-13 * (1 + size));
    }
}

TEST(VoidSphere, OfFourTouchingGrainsHasItsClosedForm) {
    const std::array<Vec3, 4> x = {{{0, 0, 0}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}}};
    const double r = std::sqrt(0.5);
    EXPECT_NEAR(void_sphere(x, {r, r, r, r}).radius / r, 0.224745, 5e-7); // sqrt(3/2) - 1
    const double overlapping = std::sqrt(0.75) + 0.1;                     // over the whole of the tetrahedron
    EXPECT_NEAR(void_sphere(x, {overlapping, overlapping, overlapping, overlapping}).radius, -0.1, 1e-14);
    EXPECT_EQ(void_sphere({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, {r, r, r, r}).radius, 0);
}

TEST(Voids, OfTouchingLatticesHaveAsManyWindowsAsTheirClosedForm) {
    for (const int cells : {1, 2, 3}) { // down to voids whose neighbors are their own images
        for (const VoidMerge merge : {VoidMerge::Center, VoidMerge::Overlap}) {
            expect_constrictions(test::simple_cubic(cells, 1), merge, 3, std::sqrt(2.0) - 1);
            expect_constrictions(test::body_centered(cells, 1), merge, 12, std::sqrt(1.5) - 1);
            expect_constrictions(test::face_centered(cells, 1), merge, 8, 2 / std::sqrt(3.0) - 1);
        }
        // The two halves of each square count by themselves where nothing is merged: the reference's choice.
        expect_constrictions(test::simple_cubic(cells, 1), VoidMerge::None, 6, std::sqrt(2.0) - 1);
        expect_constrictions(test::body_centered(cells, 1), VoidMerge::None, 12, std::sqrt(1.5) - 1);
    }
}

TEST(Voids, MergeWhereTheSpheresOfABodyCenteredLatticeReachEachOther) {
    // Side a: spheres of radius a sqrt(5)/4 - r, a sqrt(2)/4 apart. They overlap from a = 2.6162 r on, and hold each
    // other's centers from 4.8671 r on.
    const auto count = [](double a, VoidMerge merge) {
        return constrictions(test::lattice(3, a, 1, {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}}), merge).diameter.size();
    };
    EXPECT_EQ(count(2.616, VoidMerge::Overlap), 12U * 54);
    EXPECT_EQ(count(2.617, VoidMerge::Overlap), 0U); // one void, which runs through the cell in all directions
    EXPECT_EQ(count(4.867, VoidMerge::Center), 12U * 54);
    EXPECT_EQ(count(4.868, VoidMerge::Center), 0U);
    EXPECT_EQ(count(4.868, VoidMerge::None), 12U * 54);
}

TEST(Voids, OfASimpleCubicLatticeThatLacksAGrainMergeIntoOneAroundTheHole) {
    // Side a: around the hole an octahedron (sphere of radius a - r) and eight cubes without a corner (a sqrt(3)/2 -
    // r), a sqrt(3)/2 from it, behind triangles of side a sqrt(2).
    const int cells = 4;
    const auto lacking_one = [&](double a) {
        Packing packing = test::lattice(cells, a, 1, {{0.1, 0.2, 0.3}});
        packing.position.erase(packing.position.begin() + 21);
        packing.radius.erase(packing.radius.begin() + 21);
        return packing;
    };
    const auto count_of = [](const Constrictions& found, double radius) {
        return std::count_if(found.diameter.begin(), found.diameter.end(), [&](double d) {
            return std::abs(d - 2 * radius) < 1e-12;
        });
    };
    const auto expect = [&](double a, VoidMerge merge, std::ptrdiff_t squares, std::ptrdiff_t triangles) {
        const Constrictions found = constrictions(lacking_one(a), merge);
        EXPECT_EQ(count_of(found, a * std::sqrt(0.5) - 1), squares) << a;
        EXPECT_EQ(count_of(found, a * std::sqrt(2.0 / 3) - 1), triangles) << a;
        EXPECT_EQ(std::ssize(found.diameter), squares + triangles) << a;
    };
    const std::ptrdiff_t windows = 3 * cells * cells * cells, at_the_hole = 12;
    expect(2.1, VoidMerge::None, 2 * (windows - at_the_hole) + at_the_hole, 8);
    expect(2.1, VoidMerge::Center, windows, 8);
    expect(2.1, VoidMerge::Overlap, windows - at_the_hole, 0); // the nine are one void
    expect(8.0, VoidMerge::Center, windows - at_the_hole, 0);
    expect(8.0, VoidMerge::Overlap, 0, 0);
}

TEST(Voids, AreThoseOfASlowMergeOfEveryPairInARandomPacking) {
    // Labels spread over neighbors that are one until none changes; periods do not count, for no void here meets its
    // own image without running through the cell.
    const Packing packing = test::random_packing(identity(), 250, 0.04, 0.1, 21);
    const PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
    const Pores& pores = network.pores;
    const Throats& throats = network.throats;
    std::vector<VoidSphere> sphere;
    for (std::size_t p = 0; p < pores.size(); ++p) {
        std::array<Vec3, 4> x;
        std::array<double, 4> r;
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = packing.position[pores.grain[p][k]] + shift(packing.h, pores.grain_image[p][k]);
            r[k] = packing.radius[pores.grain[p][k]];
        }
        sphere.push_back(void_sphere(x, r));
    }
    std::vector<std::uint32_t> label(pores.size());
    std::iota(label.begin(), label.end(), std::uint32_t{0});
    const auto joins = [&](std::size_t t) {
        const VoidSphere &a = sphere[throats.side[t][0]], &b = sphere[throats.side[t][1]];
        const double apart = norm(b.center + shift(packing.h, throats.image[t]) - a.center);
        return a.radius > 0 && b.radius > 0 && (apart < a.radius || apart < b.radius);
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t t = 0; t < throats.size(); ++t) {
            std::uint32_t &one = label[throats.side[t][0]], &other = label[throats.side[t][1]];
            if (joins(t) && one != other) {
                one = other = std::min(one, other);
                changed = true;
            }
        }
    }
    std::vector<std::uint32_t> expected;
    for (std::uint32_t t = 0; t < throats.size(); ++t) {
        if (label[throats.side[t][0]] != label[throats.side[t][1]]) {
            expected.push_back(t);
        }
    }
    EXPECT_LT(expected.size(), throats.size()); // something was merged
    EXPECT_GT(expected.size(), throats.size() / 10);
    EXPECT_EQ(throats_between_voids(network, packing.position, packing.radius, VoidMerge::Center), expected);
}

TEST(Voids, MergeMoreWhereMoreCounts) {
    const Packing packing = test::reference_spheres("packing2000");
    const PoreNetwork network = build_network(packing.h, packing.position, packing.radius);
    std::vector<std::vector<std::uint32_t>> found;
    for (const VoidMerge merge : every_merge) {
        found.push_back(throats_between_voids(network, packing.position, packing.radius, merge));
    }
    EXPECT_EQ(found[0].size(), network.throats.size());
    for (std::size_t k = 1; k < found.size(); ++k) {
        EXPECT_LT(found[k].size(), found[k - 1].size());
        EXPECT_TRUE(std::includes(found[k - 1].begin(), found[k - 1].end(), found[k].begin(), found[k].end()));
    }
}

} // namespace
} // namespace suffuse::pores
