#include "suffuse/flow/reynolds.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace suffuse::flow {
namespace {

TEST(SauterDiameter, IsThatOfEqualSurfacePerVolume) {
    EXPECT_DOUBLE_EQ(sauter_diameter(std::vector{0.5e-3, 1.5e-3}), 2.8e-3); // of 1 mm and 3 mm: (1 + 27)/(1 + 9)
    EXPECT_EQ(sauter_diameter({}), 0);
}

TEST(ReynoldsNumber, OfAMillimeterPerSecondInGrainsOfAMillimeterIsOne) {
    const Fluid water;
    const double permeability = 1e-3 / conductivity(1, water);            // 1 mm/s at i = 1
    EXPECT_NEAR(reynolds_number(permeability, 1, 1e-3, water), 1, 1e-12); // rounding
    EXPECT_NEAR(reynolds_number(permeability, -0.1, 1e-3, water), 0.1, 1e-12);
}

TEST(InertiaOfTheWater, LeavesWhatErgunsResistanceDoesAtTheSameGradient) {
    EXPECT_EQ(share_left_by_inertia(0, 0.4), 1);
    for (const double reynolds : {0.01, 1.0, 100.0}) {
        const double porosity = 0.4, left = share_left_by_inertia(reynolds, porosity);
        const double viscous = 150 * (1 - porosity) * left, inertial = 1.75 * reynolds * left * left;
        EXPECT_NEAR((viscous + inertial) / (150 * (1 - porosity)), 1, 1e-12) << reynolds; // rounding
    }
}

TEST(InertiaOfTheWater, IsReportedWhereItTakesATenthOfTheFlux) {
    const double porosity = 0.4, left = 0.9; // Ergun: (1 - left) 150 (1 - n) = 1.75 Re left^2
    const double limit = (1 - left) * 150 * (1 - porosity) / (1.75 * left * left);
    EXPECT_EQ(words_of_inertia("in the sample", 1, 0.99 * limit, porosity), "");
    const std::string words = words_of_inertia("in the sample", -2, 1.01 * limit, porosity);
    EXPECT_EQ(words.find("at i = -2 the water in the sample has a Reynolds number of 6.4"), 0U) << words;
    EXPECT_NE(words.find("about 90 %"), std::string::npos) << words;
}

} // namespace
} // namespace suffuse::flow
