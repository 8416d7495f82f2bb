// Samples side by side, and what of them fits into a bound of memory.

#include "suffuse/plan/fit_memory.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

namespace suffuse::plan {
namespace {

/// Samples of one stage each, of 1 GB, 2 GB and so on.
RunPlan samples_of_gigabytes(int count, int at_once) {
    RunPlan plan;
    plan.speed.at_once = at_once;
    for (int k = 1; k <= count; ++k) {
        StageEstimate stage;
        stage.study = "soil/rep=" + std::to_string(k);
        stage.stage = "initial";
        stage.grains = 1'000'000 * k;
        stage.memory = 1e9 * k;
        plan.stages.push_back(stage);
    }
    sum_up(plan);
    return plan;
}

TEST(FitMemory, LeavesSamplesSideBySideThatFit) {
    const RunPlan plan = samples_of_gigabytes(4, 4); // 4 + 3 + 2 + 1 GB
    EXPECT_EQ(samples_within(plan, 11e9), 4);
    EXPECT_EQ(samples_within(plan, 9.9e9), 3);
    EXPECT_EQ(samples_within(plan, 7.5e9), 2);
    EXPECT_EQ(samples_within(plan, 6e9), 1);
}

TEST(FitMemory, RefusesWhatDoesNotFitAloneAndSaysWhatWould) {
    try {
        static_cast<void>(samples_within(samples_of_gigabytes(4, 2), 2.04e9));
        FAIL() << "4 GB do not fit into 2 GB";
    } catch (const IoError& error) {
        const std::string message = error.what();
        for (const char* const part :
             {"soil/rep=4/initial needs up to 4.0 GB", "4,000,000 grains", "may use 2.0 GB", "about 2,000,000 fit",
              "--memory 4.1 GB"}) {
            EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
        }
    }
}

TEST(FitMemory, PlansAnewForThoseThatFit) {
    const auto make = [](int at_once) { return samples_of_gigabytes(4, at_once); };
    EXPECT_EQ(plan_within(7.5e9, 4, make).speed.at_once, 2);
    EXPECT_EQ(plan_within(1e11, 4, make).speed.at_once, 4);
}

TEST(FitMemory, OfARunThatNeedsNothingMoreIsAlwaysEnough) {
    EXPECT_EQ(samples_within(samples_of_gigabytes(0, 1), 1e6), 1);
}

} // namespace
} // namespace suffuse::plan
