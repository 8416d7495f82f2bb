#include "suffuse/plan/plan_record.hpp"

#include "suffuse/casefile/load_case.hpp"
#include "suffuse/plan/sum_ranges.hpp"
#include "suffuse/record/folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"

namespace suffuse::plan {
namespace {

TEST(PlanError, IsTheDistanceOfTheMiddleFromTheTruth) {
    EXPECT_DOUBLE_EQ(middle({2, 8}), 4);
    EXPECT_DOUBLE_EQ(middle({0, 4}, 1), 2);
    // Steps 400 for 500, 400 and 200: 20 %, 0 % and 100 % off. Seconds 4 for 4, 2 and 5, the last of a stage too short
    // to count.
    const std::vector<StageOutcome> outcomes = {
        {{200, 800}, {2, 8}, 500, 4}, {{200, 800}, {2, 8}, 400, 2}, {{200, 800}, {2, 8}, 200, 0.1}};
    const auto error = measure_plan_error(outcomes);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->stages, 2);
    EXPECT_DOUBLE_EQ(error->of_steps, 0.2);
    EXPECT_DOUBLE_EQ(error->of_seconds, 0.5); // of 0 % and 100 %
    EXPECT_DOUBLE_EQ(error->planned_seconds.least, sum_ranges({{2, 8}, {2, 8}}).least);
    EXPECT_DOUBLE_EQ(error->seconds, 6);
    EXPECT_DOUBLE_EQ(error->of_all_seconds, 8.0 / 6 - 1);
    EXPECT_FALSE(measure_plan_error({}));
    EXPECT_FALSE(measure_plan_error({outcomes.back()}));
}

RunPlan plan_of(double seconds) {
    const std::string text = test::in_checkout("examples/replay/case.toml");
    RunPlan plan = plan_run(casefile::load_case(text).value, {1e7, 500, 1});
    for (StageEstimate& stage : plan.stages) {
        stage.seconds = {seconds, seconds};
        stage.steps = {1000, 1000};
    }
    return plan;
}

TEST(PlanRecord, HoldsTheExpectedAndTheActualResult) {
    const test::TempFolder folder;
    EXPECT_FALSE(record_outcome(folder.path())); // no plan
    keep_plan(folder.path(), plan_of(3));
    EXPECT_FALSE(record_outcome(folder.path())); // no stage is done
    std::filesystem::create_directories(folder / "studies/replay/settled");
    record::write_json(folder / "studies/replay/settled/stage.json", {{"steps", 2000}, {"wall_seconds", 4.0}});
    const auto error = record_outcome(folder.path());
    ASSERT_TRUE(error);
    EXPECT_DOUBLE_EQ(error->of_steps, 0.5);
    EXPECT_DOUBLE_EQ(error->of_seconds, 0.25);
    const nlohmann::json kept = record::read_json(folder / "plan.json");
    EXPECT_EQ(kept.at("stages").at(1).at("steps_taken"), 2000);
    EXPECT_EQ(kept.at("error").at("median_of_seconds"), 0.25);
}

TEST(PlanRecord, WhatWasPricedBeforeTheFirstStepStays) {
    const test::TempFolder folder;
    RunPlan first = plan_of(3);
    first.stages[3].seconds = {}; // after the requested last stage
    keep_plan(folder.path(), first);
    keep_plan(folder.path(), plan_of(5));
    const nlohmann::json stages = record::read_json(folder / "plan.json").at("stages");
    EXPECT_EQ(stages.at(1).at("seconds").at(0), 3);
    EXPECT_EQ(stages.at(3).at("seconds").at(0), 5);
}

} // namespace
} // namespace suffuse::plan
