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
            {.gradient = gradient,
             .held_for = 2,
             .ended = ended,
             .ended_by = ended ? erosion::HoldEnd::Rest : erosion::HoldEnd::HoldLimit,
             .moving_mass_share = 0.5 * (1 + fed)}
        );
        const auto holds = static_cast<double>(migration.result.holds.size());
        migration.result.rows.push_back({.time = 2 * holds, .gradient = gradient, .fed_mass = fed});
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

TEST(MigrationRemarks, NameTheLimitThatLeftGradientsOut) {
    erosion::Migration migration = moving(0);
    migration.cut_by = erosion::HoldEnd::TimeLimit;
    migration.result.holds.pop_back();
    const std::vector<std::string> remarks = migration_remarks(migration, {.gradients = {0.1, 0.2, 0.3, 0.4}});
    EXPECT_EQ(remarks.at(1), "`time_at_most` ended the stage at i = 0.2; the 2 gradients after it were not applied");
    EXPECT_NE(remarks.at(0).find("a larger `hold_at_most` holds it longer"), std::string::npos) << remarks.at(0);
}

} // namespace
} // namespace suffuse::run
