#include "apps/sweep_tasks.hpp"

#include <gtest/gtest.h>

namespace suffuse::apps {
namespace {

std::vector<std::size_t> sizes_of(const std::vector<Task>& tasks) {
    std::vector<std::size_t> sizes;
    sizes.reserve(tasks.size());
    for (const Task& task : tasks) {
        sizes.push_back(task.samples.size());
    }
    return sizes;
}

TEST(SweepTasks, NeighborsShareATaskUpToItsTimeAndLongOnesStayAlone) {
    std::vector<Task> tasks;
    for (const double seconds : {4.0, 4.0, 4.0, 100.0, 2.0, 9.0}) {
        tasks.push_back({{std::to_string(tasks.size())}, {seconds, seconds}});
    }
    const std::vector<Task> packed = pack_tasks(tasks, 10);
    EXPECT_EQ(sizes_of(packed), (std::vector<std::size_t>{2, 1, 1, 1, 1}));
    EXPECT_EQ(packed.front().samples, (std::vector<std::string>{"0", "1"})) << "in the order of the case";
    EXPECT_EQ(packed.front().seconds.most, 8);
    EXPECT_EQ(sizes_of(pack_tasks(tasks, 1)), std::vector<std::size_t>(6, 1));
    EXPECT_EQ(sizes_of(pack_tasks(tasks, 1e6)), std::vector<std::size_t>{6});
    EXPECT_TRUE(pack_tasks({}, 10).empty());
}

TEST(SweepTasks, TheMiddleOfAPriceDecides) {
    const std::vector<Task> tasks(3, {{"a"}, {1, 100}}); // 10 s, by the middle
    EXPECT_EQ(sizes_of(pack_tasks(tasks, 20)), (std::vector<std::size_t>{2, 1}));
    EXPECT_EQ(sizes_of(pack_tasks(tasks, 19)), (std::vector<std::size_t>{1, 1, 1}));
}

TEST(SweepTasks, ATaskCostsTheStagesOfItsSamplesAndTheirStarts) {
    plan::RunPlan plan;
    for (const auto& [sample, seconds] : {std::pair{"a", 3.0}, std::pair{"a", 4.0}, std::pair{"b", 50.0}}) {
        plan::StageEstimate stage;
        stage.study = sample;
        stage.seconds = {seconds, 2 * seconds};
        plan.stages.push_back(stage);
    }
    std::vector<Task> tasks{{{"a"}, {}}, {{"c"}, {}}, {{"a", "b"}, {}}};
    price_tasks(tasks, plan);
    const Range start = tasks[1].seconds; // of a sample that the cache holds
    EXPECT_GT(start.least, 0);
    EXPECT_DOUBLE_EQ(tasks[0].seconds.least, 7 + start.least);
    EXPECT_DOUBLE_EQ(tasks[0].seconds.most, 14 + start.most);
    EXPECT_DOUBLE_EQ(tasks[2].seconds.most, 114 + 2 * start.most);
}

} // namespace
} // namespace suffuse::apps
