#include "suffuse/figures/figures_migration.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::figures {
namespace {

MigrationCurve two_gradients() {
    MigrationCurve curve{"sand", {.fines_mass = 2}};
    for (int k = 0; k < 1000; ++k) {
        curve.result.rows.push_back(
            {.time = 0.01 * k,
             .gradient = k < 500 ? 0.1 : 0.2,
             .permeability = 1e-9 + 1e-12 * k,
             .eroded_mass = 1e-3 * k}
        );
    }
    curve.result.holds = {
        {.gradient = 0.1, .ended = true, .eroded_mass_share = 0.25, .permeability = 1.5e-9},
        {.gradient = 0.2, .ended = false, .eroded_mass_share = 0.4995, .permeability = 1.999e-9}};
    return curve;
}

TEST(MigrationFigures, HaveAPointForEachGradientAndSayWhichWereCut) {
    const auto figure = migration_by_gradient({two_gradients()});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.rows(), 2U);
    EXPECT_DOUBLE_EQ(figure->table.numbers("eroded")[0], 25);
    EXPECT_DOUBLE_EQ(figure->table.numbers("permeability")[0], 150);
    EXPECT_EQ(figure->table.words("motion")[1], "still moving");
    EXPECT_NE(figure->caption.find("50 % of the fines' mass eroded"), std::string::npos) << figure->caption;
    EXPECT_NE(figure->caption.find("ends at 200 % of that at first"), std::string::npos) << figure->caption;
}

TEST(MigrationFigures, OverTimeHaveAtMostSomeHundredPointsAndTheLast) {
    const auto figure = migration_in_time({two_gradients()});
    ASSERT_TRUE(figure);
    EXPECT_LE(figure->table.rows(), 401U);
    EXPECT_DOUBLE_EQ(figure->table.numbers("time").back(), 9.99);
    EXPECT_DOUBLE_EQ(figure->table.numbers("eroded").back(), 49.95);
}

/// A stage whose fines leave in proportion to the energy that the flow spends, by so much for each joule, but for
/// `off`.
MigrationCurve five_gradients(double mass_a_joule, double off) {
    MigrationCurve curve{"silt", {.fines_mass = 1e-3}};
    double energy = 0, mass = 0;
    for (int k = 1; k <= 5; ++k) {
        const double power = 1e-6 * k, held_for = 0.5 + 0.1 * k;
        energy += power * held_for;
        mass += (mass_a_joule * power + (k % 2 == 0 ? off : -off)) * held_for;
        const double end = (curve.result.rows.empty() ? 0 : curve.result.rows.back().time) + held_for;
        curve.result.rows.push_back({.time = end - 0.1, .energy = energy - 0.1 * power});
        curve.result.rows.push_back({.time = end, .energy = energy});
        curve.result.holds.push_back(
            {.gradient = 0.1 * k, .held_for = held_for, .eroded_mass_share = mass / curve.result.fines_mass}
        );
    }
    return curve;
}

TEST(MigrationFigures, HaveTheMeanRateAndPowerOfEachHold) {
    const RatesByPower rates = rates_by_power(five_gradients(2, 0).result);
    ASSERT_EQ(rates.power.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(rates.power[k], 1e-6 * static_cast<double>(k + 1), 1e-15);
        EXPECT_NEAR(rates.rate[k], 2 * rates.power[k], 1e-15);
    }
}

TEST(MigrationFigures, DrawALineOverThePowerOnlyWhereTheDataCarryOne) {
    const auto straight = migration_by_power({five_gradients(2, 1e-8)});
    ASSERT_TRUE(straight);
    EXPECT_NE(straight->caption.find("mg for each joule"), std::string::npos) << straight->caption;
    EXPECT_NEAR(straight->table.numbers("line")[4] - straight->table.numbers("line")[0], 8, 0.2); // of 2 kg/J, 4 µW
    EXPECT_EQ(straight->chart.at("layer").size(), 2U);
    MigrationCurve late = five_gradients(2, 1e-8); // nothing leaves below the last two
    for (std::size_t k = 0; k < 3; ++k) {
        late.result.holds[k].eroded_mass_share = 0;
    }
    const auto of_two = migration_by_power({late});
    ASSERT_TRUE(of_two);
    EXPECT_EQ(of_two->table.rows(), 5U);
    EXPECT_NE(of_two->caption.find("2 gradients with losses carry no line"), std::string::npos) << of_two->caption;
    const auto scattered = migration_by_power({five_gradients(2, 1e-5)});
    ASSERT_TRUE(scattered);
    EXPECT_NE(scattered->caption.find("gradients with losses carry no line"), std::string::npos) << scattered->caption;
    EXPECT_TRUE(std::isnan(scattered->table.numbers("line")[0]));
    EXPECT_EQ(scattered->chart.at("layer").size(), 1U);
    EXPECT_FALSE(migration_by_power({five_gradients(0, 0)})) << "nothing left";
}

TEST(MigrationFigures, HaveProfilesBeforeAndAtTheEndOfGradients) {
    MigrationCurve curve = five_gradients(2, 0);
    EXPECT_FALSE(migration_profiles({curve}));
    erosion::SampleProfile& profile = curve.result.sample;
    profile.slices = 3;
    profile.step.assign(6, 0.5e-3);
    profile.porosity.assign(6, {0.3, 0.4, 0.5});
    profile.fines = profile.porosity;
    profile.permeability.assign(6, {1e-10, 2e-10, 3e-10});
    const auto figure = migration_profiles({five_gradients(1, 0), curve});
    ASSERT_TRUE(figure);
    EXPECT_EQ(figure->table.rows(), 18U);
    EXPECT_DOUBLE_EQ(figure->table.numbers("middle")[1], 0.75);
    EXPECT_DOUBLE_EQ(figure->table.numbers("fines")[2], 50);
    EXPECT_EQ(figure->table.words("state").front(), "before");
    EXPECT_EQ(figure->table.words("state").back(), "after i = 0.5");
}

TEST(MigrationFigures, AreNotDrawnOfNothingNorOfOneGradientAgainstItself) {
    EXPECT_FALSE(migration_by_gradient({}) || migration_in_time({}));
    EXPECT_FALSE(migration_in_time({{"nothing", {}}}));
    MigrationCurve one = two_gradients();
    one.result.holds.resize(1);
    EXPECT_FALSE(migration_by_gradient({one}));
    EXPECT_TRUE(migration_in_time({one}));
}

} // namespace
} // namespace suffuse::figures
