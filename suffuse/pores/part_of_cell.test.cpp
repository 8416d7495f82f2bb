// Parts of a cell that know nothing of each other: together they fill it once, and hold what one part alone would.

#include "suffuse/pores/part_of_cell.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include <algorithm>
#include <cmath>
#include <set>

namespace suffuse::pores {
namespace {

using Shape = std::array<Corner, 4>;

struct Whole {
    std::multiset<Shape> shapes; ///< of all parts, the same for all images
    double volume = 0;           ///< [-]
};

Vec3 place_of(const ExactPacking& packing, const Corner& corner) {
    return packing.position[corner.grain] + cell::shift(packing.h, corner.image);
}

double volume_of(const ExactPacking& packing, const Shape& corner) {
    const Vec3 a = place_of(packing, corner[0]);
    return dot(place_of(packing, corner[1]) - a,
               cross(place_of(packing, corner[2]) - a, place_of(packing, corner[3]) - a)) /
           6;
}

Whole all_parts(const ExactPacking& packing, const Cuts& cuts) {
    Whole whole;
    for (int a = 0; a < cuts[0]; ++a) {
        for (int b = 0; b < cuts[1]; ++b) {
            for (int c = 0; c < cuts[2]; ++c) {
                for (const Shape& corner : triangulate_part(packing, cuts, {a, b, c}).corner) {
                    const double volume = volume_of(packing, corner);
                    EXPECT_GT(volume, 0);
                    whole.volume += volume;
                    whole.shapes.insert(canonical(corner).corners);
                }
            }
        }
    }
    return whole;
}

TEST(PartOfCell, PartsFillTheCellOnceHoweverItIsCut) {
    const test::Packing given = test::random_packing(diagonal({1.0, 1.1, 0.9}), 60, 0.03, 0.1, 3);
    const ExactPacking packing = exact_packing(given.h, given.position, given.radius);
    const Whole uncut = all_parts(packing, {1, 1, 1});
    const double cell = std::abs(determinant(packing.h));
    EXPECT_NEAR(uncut.volume, cell, 1e-12 * cell); // rounding of some hundreds of volumes
    for (const Cuts& cuts : {Cuts{2, 1, 1}, Cuts{2, 2, 1}, Cuts{1, 3, 2}}) {
        const Whole cut = all_parts(packing, cuts);
        EXPECT_NEAR(cut.volume, cell, 1e-12 * cell);
        EXPECT_EQ(cut.shapes, uncut.shapes);
    }
}

TEST(PartOfCell, NeighborsLieAcrossTheirFacetsAndKnowEachOther) {
    const test::Packing given = test::random_packing(identity(), 60, 0.03, 0.1, 4);
    const ExactPacking packing = exact_packing(given.h, given.position, given.radius);
    const PartTetrahedra part = triangulate_part(packing, {2, 1, 1}, {0, 0, 0});
    std::size_t inner = 0;
    for (std::uint32_t t = 0; t < part.corner.size(); ++t) {
        for (const std::uint32_t other : part.neighbor[t]) {
            if (other != PartTetrahedra::none) {
                EXPECT_EQ(std::ranges::count(part.neighbor[other], t), 1);
                ++inner;
            }
        }
    }
    EXPECT_GT(inner, part.corner.size()) << "most facets are within the part";
}

} // namespace
} // namespace suffuse::pores
