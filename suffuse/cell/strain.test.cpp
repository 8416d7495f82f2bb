#include "suffuse/cell/strain.hpp"

#include <gtest/gtest.h>

namespace suffuse::cell {
namespace {

constexpr double rounding = 1e-15;

TEST(Strain, OfACellThatIsHalvedIsTheLogarithmOfTwo) {
    const Mat3 from = diagonal({2, 3, 4}), to = diagonal({1, 3, 8});
    const Vec3 strain = axial_strains(from, to);
    EXPECT_NEAR(strain.x, std::log(2), rounding);
    EXPECT_NEAR(strain.y, 0, rounding);
    EXPECT_NEAR(strain.z, -std::log(2), rounding);
    EXPECT_NEAR(volumetric_strain(from, to), strain.x + strain.y + strain.z, rounding);
    EXPECT_NEAR(largest_strain({0.1, -0.3, 0.2}), 0.3, 0);
}

TEST(Strain, OfShearChangesNoVolume) {
    Mat3 to = diagonal({2, 3, 4});
    to(0, 1) = 1;
    EXPECT_NEAR(volumetric_strain(diagonal({2, 3, 4}), to), 0, rounding);
}

TEST(Strain, OfStepsAddsUp) {
    const Mat3 from = diagonal({1, 1, 1}), middle = diagonal({0.9, 1.1, 1}), to = diagonal({0.7, 1.3, 0.8});
    const Vec3 sum = axial_strains(from, middle) + axial_strains(middle, to);
    EXPECT_NEAR(norm(sum - axial_strains(from, to)), 0, rounding);
}

} // namespace
} // namespace suffuse::cell
