#include "suffuse/figures/figures_migration.hpp"

#include <gtest/gtest.h>

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
