// What a machine lacks for a run.

#include "apps/shortages.hpp"

#include <gtest/gtest.h>

namespace suffuse::apps {
namespace {

TEST(Shortages, OfDiskAreReportedBeforeARunIsStarted) {
    plan::RunPlan plan;
    EXPECT_TRUE(shortages(plan, ".").empty());
    plan.disk = 1e24;
    ASSERT_EQ(shortages(plan, ".").size(), 1U);
    EXPECT_NE(shortages(plan, ".").back().find("and the disk has"), std::string::npos);
}

} // namespace
} // namespace suffuse::apps
