#include "suffuse/run/migration_numbers.hpp"

#include <gtest/gtest.h>

namespace suffuse::run {
namespace {

/// Of two gradients at which motion does not end, and which move all of 1 kg of fines.
erosion::Migration moving(double fed) {
    erosion::Migration migration;
    migration.rested = true;
    migration.result.fines_mass = 1;
    migration.ledger.mass = {1};
    for (const double gradient : {0.1, 0.2, 0.3}) {
        const bool ended = gradient < 0.15;
        migration.result.holds.push_back(
            {.gradient = gradient, .held_for = 2, .ended = ended, .moving_mass_share = 0.5 * (1 + fed)}
        );
        migration.result.rows.push_back({.gradient = gradient, .fed_mass = fed});
    }
    return migration;
}

std::string remark_on(double fed) {
    return migration_remarks(moving(fed), {.gradients = {0.1, 0.2, 0.3}}).at(0);
}

TEST(MigrationRemarks, CountTheGradientsAtWhichMotionHadNotEnded) {
    EXPECT_EQ(
        remark_on(0).find(
            "at i = 0.2, the first of 2 such gradients, motion had not ended after 2 s: 50 % of the fines' "
            "mass still moved"
        ),
        0U
    ) << remark_on(0);
}

TEST(MigrationRemarks, CountWhatTheWaterBroughtAsFines) {
    EXPECT_NE(remark_on(2).find("50 % of the fines' mass, with what the water brought, still moved"), std::string::npos)
        << remark_on(2);
}

} // namespace
} // namespace suffuse::run
