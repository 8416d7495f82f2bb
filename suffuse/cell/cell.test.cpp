#include "suffuse/cell/cell.hpp"

#include <gtest/gtest.h>

namespace suffuse::cell {
namespace {

const Mat3 sheared = from_columns({4, 0, 0}, {1, 3, 0}, {-2, 0.5, 5});

TEST(Cell, VolumeAndWidthsOfAShearedCellAreThoseOfItsFaces) {
    const Cell cell{sheared, {}};
    EXPECT_DOUBLE_EQ(volume(cell), 60);
    const Vec3 w = widths(sheared);
    // Width along c: the third edge stands 5 above the plane of the first two.
    EXPECT_NEAR(w.z, 5, 1e-14);
    for (int a = 0; a < 3; ++a) { // width times area of the face is the volume
        const Vec3 p = sheared.column((a + 1) % 3), q = sheared.column((a + 2) % 3);
        EXPECT_NEAR(w[a] * norm(cross(p, q)), 60, 1e-12);
    }
}

TEST(Cell, AWrappedPointLiesInsideAndAWholePeriodAway) {
    const Mat3 back = inverse(sheared);
    for (const Vec3& x : {Vec3{100, -30, 7}, Vec3{-1e-3, 2, 4.9}, Vec3{0.1, 0.1, 0.1}}) {
        const Vec3 home = wrapped(sheared, back, x), s = back * home;
        for (int a = 0; a < 3; ++a) {
            EXPECT_GE(s[a], -1e-13);
            EXPECT_LE(s[a], 1 + 1e-13);
        }
        EXPECT_LE(norm(home + shift(sheared, period_of(back, x)) - x), 1e-13 * (1 + norm(x)));
    }
}

TEST(Cell, ImagesAddLikeTheirShifts) {
    const Image p{1, -2, 3}, q{0, 5, -1};
    EXPECT_EQ(shift(sheared, p + q), shift(sheared, p) + shift(sheared, q));
    EXPECT_EQ(p - p, Image{});
}

} // namespace
} // namespace suffuse::cell
