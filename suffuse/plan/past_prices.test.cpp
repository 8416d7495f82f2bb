#include "suffuse/plan/past_prices.hpp"

#include "suffuse/plan/plan_record.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <fstream>

namespace suffuse::plan {
namespace {

RunPlan plan_of_one(const std::string& kind) {
    RunPlan plan;
    plan.speed = {1e7, 1000, 1};
    StageEstimate stage;
    stage.study = "dyke", stage.stage = "loose", stage.verb = "compact", stage.kind = kind;
    stage.steps = {1000, 4000}, stage.tables_steps = 2000;
    stage.seconds = {1, 4}, stage.tables_seconds = 2;
    plan.stages = {stage};
    sum_up(plan);
    return plan;
}

/// A run whose stage took so much, and what the cache has learned of it.
void run_once(const test::TempFolder& cache, int number, double steps, double seconds) {
    const std::filesystem::path run = cache / fmt::format("run-{}", number);
    std::filesystem::create_directories(run / "studies/dyke/loose");
    keep_plan(run, plan_of_one("compact: wide, frictional"));
    record::write_json(run / "studies/dyke/loose/stage.json", {{"steps", steps}, {"wall_seconds", seconds}});
    static_cast<void>(record_outcome(run));
    remember_prices(cache.path(), run);
    remember_prices(cache.path(), run); // each stage once
}

TEST(PastPrices, CorrectThePlanOnceFiveStagesOfAKindAreKnown) {
    const test::TempFolder cache;
    for (int k = 0; k < 4; ++k) {
        run_once(cache, k, 6000, 8);
    }
    RunPlan plan = plan_of_one("compact: wide, frictional");
    PastPrices(cache.path()).correct(plan);
    EXPECT_EQ(plan.stages[0].steps.most, 4000); // four say less than the tables
    run_once(cache, 4, 6000, 8);
    PastPrices(cache.path()).correct(plan);
    EXPECT_NEAR(middle(plan.stages[0].steps), 6000, 1e-9 * 6000);
    EXPECT_NEAR(plan.stages[0].steps.most / 6000, 1.15, 1e-9); // all took the same: no less than this
    EXPECT_NEAR(middle(plan.seconds), 8, 1e-9);                // of the whole plan, too
    RunPlan other = plan_of_one("compact: faithful, frictional");
    PastPrices(cache.path()).correct(other);
    EXPECT_EQ(other.stages[0].steps.most, 4000);
}

TEST(PastPrices, AreOfTheLatestStagesAndAsWideAsTheirScatter) {
    const test::TempFolder cache;
    std::ofstream file(cache / "prices.txt");
    for (int k = 0; k < 100; ++k) {
        file << "9 9 compact\n"; // of an earlier, slower machine
    }
    for (int k = 0; k < 60; ++k) {
        file << (k % 2 == 0 ? "0.5 0.5 compact\n" : "2 2 compact\n");
    }
    file << "not a price\n-1 nan compact\n3\n";
    file.close();
    RunPlan plan = plan_of_one("compact");
    PastPrices(cache.path()).correct(plan);
    EXPECT_NEAR(plan.stages[0].steps.least, 1000, 1e-6);
    EXPECT_NEAR(plan.stages[0].steps.most, 4000, 1e-6);
}

TEST(PastPrices, OfNoCacheChangeNothing) {
    RunPlan plan = plan_of_one("compact");
    PastPrices({}).correct(plan);
    PastPrices("/nowhere").correct(plan);
    EXPECT_EQ(plan.stages[0].seconds.most, 4);
    remember_prices({}, "/nowhere");
}

} // namespace
} // namespace suffuse::plan
