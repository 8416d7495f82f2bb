#include "suffuse/run/section_tables.hpp"

#include <gtest/gtest.h>

namespace suffuse::run {
namespace {

TEST(KozenyCarman, OfEqualSpheresIsTheClosedForm) {
    const double d = 1e-3, n = 0.4;
    EXPECT_NEAR(kozeny_carman({d / 2, d / 2, d / 2}, n), n * n * n * d * d / (180 * 0.6 * 0.6), 1e-22); // rounding
}

TEST(KozenyCarman, TheSauterDiameterIsThatOfEqualSurfacePerVolume) {
    // Of spheres of 1 mm and 3 mm: (1 + 27)/(1 + 9) mm.
    EXPECT_NEAR(kozeny_carman({0.5e-3, 1.5e-3}, 0.4), kozeny_carman({1.4e-3}, 0.4), 1e-20); // rounding
}

} // namespace
} // namespace suffuse::run
