#include "suffuse/figures/figures_energy.hpp"

#include <gtest/gtest.h>

namespace suffuse::figures {
namespace {

/// Of 20 kJ/m3, of which 1 % is unaccounted for.
TestEnergy test_of(const std::string& name, double slip) {
    dem::EnergyParts energy;
    energy.work = 20e3;
    energy.slip = slip;
    energy.rolling = 16.6e3 - slip;
    energy.springs = 3e3;
    energy.damping = 200;
    return {name, energy};
}

TEST(EnergyFigure, ReportsTheSharesOfTheWorkAndHowNearTheyAddUpToIt) {
    const auto figure = energy_of_tests({test_of("shear", 5e3)});
    ASSERT_TRUE(figure);
    EXPECT_EQ(
        figure->caption,
        "Of the work done on the sample, sliding contacts take 25 % and rolling ones 58 %, 15 % stays in the springs, "
        "and numerical damping takes 1 %. The parts are computed independently and add up to the work within 1 %."
    );
    EXPECT_EQ(figure->table.rows(), 5U);
    EXPECT_DOUBLE_EQ(figure->table.numbers("energy")[0], 5);
    EXPECT_DOUBLE_EQ(figure->table.numbers("share")[0], 25);
}

TEST(EnergyFigure, OfSeveralTestsReportsRanges) {
    const auto figure = energy_of_tests({test_of("loose", 5e3), test_of("dense", 6e3)});
    ASSERT_TRUE(figure);
    EXPECT_NE(
        figure->caption.find("samples, sliding contacts take 25 to 30 % and rolling ones 53 to 58 %"), std::string::npos
    ) << figure->caption;
}

TEST(EnergyFigure, CountsWhatSpringsGaveBackAsWork) {
    dem::EnergyParts energy; // of a sample that liquefies
    energy.work = 100;
    energy.springs = -300;
    energy.slip = 100;
    energy.rolling = 300;
    const auto figure = energy_of_tests({{"undrained", energy}});
    ASSERT_TRUE(figure);
    EXPECT_DOUBLE_EQ(figure->table.numbers("share")[0], 25);
    EXPECT_DOUBLE_EQ(figure->table.numbers("share")[2], 0);
    EXPECT_DOUBLE_EQ(figure->table.numbers("energy")[2], -0.3);
    EXPECT_NE(figure->caption.find("Energy released by springs counts as work."), std::string::npos) << figure->caption;
}

TEST(EnergyFigure, IsNotDrawnForTestsWithoutSecondOrderWork) {
    EXPECT_FALSE(energy_of_tests({}));
    EXPECT_FALSE(energy_of_tests({{"of before", {}}}));
}

} // namespace
} // namespace suffuse::figures
