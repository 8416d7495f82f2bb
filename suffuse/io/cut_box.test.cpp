#include "suffuse/io/cut_box.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/packing_checks.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <string>

namespace suffuse::io {
namespace {

using test::TempFolder;

/// A cubic lattice of n x n x n grains that touch: spacing 1, first center in the middle of the first cell.
grains::Grains lattice(int n) {
    grains::Grains grains;
    for (int k = 0; k < n * n * n; ++k) {
        const int x = k % n, y = k / n % n, z = k / n / n;
        grains::add_grain(grains, {x + 0.5, y + 0.5, z + 0.5}, 0.5, 2600);
    }
    return grains;
}

TEST(CutBox, OfALatticeOnItsPlanesIsTheLattice) {
    grains::Grains grains = lattice(6);
    const CutGrains left_out = cut_box(grains, {{1, 1, 1}, {4, 5, 3}}, 0.1, "bed");
    EXPECT_EQ(grains.size(), 3U * 4 * 2);
    EXPECT_EQ(left_out.outside, 216U - 24);
    EXPECT_EQ(left_out.across, 0U);
    EXPECT_EQ(grains.position[0], (Vec3{0.5, 0.5, 0.5})); // from the lower corner of the box
    EXPECT_EQ(grains.id[23], 23U);
}

TEST(CutBox, ACenterOnALowerFaceIsInsideAndOneOnAnUpperFaceIsNot) {
    grains::Grains grains = lattice(4);
    cut_box(grains, {{0.5, 0.5, 0.5}, {2.5, 2.5, 2.5}}, 0.1, "bed");
    EXPECT_EQ(grains.size(), 8U);
    EXPECT_EQ(grains.position[0], (Vec3{0, 0, 0}));
}

TEST(CutBox, OfTwoGrainsThatOverlapAcrossAFaceTheSmallerIsLeftOut) {
    grains::Grains grains;
    grains::add_grain(grains, {0.1, 5, 5}, 0.5, 2600); // meets the image of the second, 0.3 away
    grains::add_grain(grains, {9.8, 5, 5}, 0.4, 2600);
    grains::add_grain(grains, {5, 5, 5}, 0.5, 2600);
    grains.velocity[2] = {1, 2, 3};
    grains::Grains tolerant = grains, strict = grains;
    const Box box{{0, 0, 0}, {10, 10, 10}};
    EXPECT_EQ(cut_box(grains, box, 1.4, "bed").across, 1U); // (0.5 + 0.4 - 0.3) / 0.4 = 1.5 is more
    EXPECT_EQ(cut_box(strict, box, 0.1, "bed").across, 1U);
    ASSERT_EQ(grains.size(), 2U);
    EXPECT_EQ(grains.radius[0], 0.5);
    EXPECT_EQ(grains.velocity[1], (Vec3{1, 2, 3}));
    EXPECT_EQ(cut_box(tolerant, box, 1.6, "bed").across, 0U);
}

TEST(CutBox, OverlapsWithinTheBoxAreNotTouched) {
    grains::Grains grains;
    grains::add_grain(grains, {4, 5, 5}, 0.5, 2600);
    grains::add_grain(grains, {4.2, 5, 5}, 0.5, 2600);
    EXPECT_EQ(cut_box(grains, {{0, 0, 0}, {10, 10, 10}}, 0.1, "bed").across, 0U);
    EXPECT_EQ(grains.size(), 2U);
}

TEST(CutBox, WithoutAVolumeOrAGrainIsRefused) {
    grains::Grains grains = lattice(2);
    EXPECT_THROW(cut_box(grains, {{1, 1, 1}, {0, 2, 2}}, 0.1, "bed"), CaseError);
    EXPECT_THROW(cut_box(grains, {{0, 0, 0}, {1, 1, 0}}, 0.1, "bed"), CaseError);
    EXPECT_THROW(cut_box(grains, {{7, 7, 7}, {9, 9, 9}}, 0.1, "bed"), CaseError);
}

const std::string walled = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ff ff ff\n-1 9\n-1 9\n-1 9\n"
                           "ITEM: ATOMS id x y z radius\n1 0 0 0 0.5\n2 3 3 3 0.5\n3 5 4 3.5 0.5\n";

TEST(CutBox, IsInTheCoordinatesOfTheFileAndReplacesItsWalls) {
    const TempFolder folder;
    write_file(folder / "bed.dump", walled);
    PackingRequest request{.file = folder / "bed.dump"};
    request.box = Box{{2, 2, 2}, {6, 6, 6}};
    const TakenPacking taken = take_packing(request);
    ASSERT_TRUE(taken.h);
    EXPECT_EQ(*taken.h, diagonal({4, 4, 4}));
    ASSERT_EQ(taken.grains.size(), 2U);
    EXPECT_EQ(taken.grains.position[1], (Vec3{3, 2, 1.5}));
    ASSERT_TRUE(taken.left_out);
    EXPECT_EQ(taken.left_out->outside, 1U);
    ASSERT_FALSE(taken.warnings.empty());
    EXPECT_NE(taken.warnings[0].find("left out: 1 grain with the center outside of the box"), std::string::npos);
    request.cell = diagonal({4, 4, 4});
    EXPECT_THROW(take_packing(request), CaseError);
}

} // namespace
} // namespace suffuse::io
