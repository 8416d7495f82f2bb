#include "suffuse/study/mobility_story.hpp"

#include <gtest/gtest.h>

namespace suffuse::study {
namespace {

/// An erosion under weight whose passes have ramps up to these gradients, and take so many fines.
struct Ramps {
    casefile::Study study;
    casefile::Variant variant;
    casefile::Stage stage{.name = "erosion", .spec = erosion::ErodeSpec{}};
    std::vector<record::FinishedStage> stages;

    explicit Ramps(const std::vector<std::pair<double, std::int64_t>>& passes) {
        erosion::ErosionResult erosion;
        for (const auto& [gradient, removed] : passes) {
            erosion::PassResult& pass = erosion.passes.emplace_back();
            pass.pass = static_cast<int>(erosion.passes.size()), pass.removed = removed;
            pass.probe.gradient = gradient;
            pass.mobility.emplace().specified_gradient = gradient;
            pass.mobility->id = {1};
            pass.mobility->ramp = {{.gradient = gradient}};
        }
        stages = {{&study, &variant, &stage, {}, {}}};
        stages.front().findings.erosion = std::move(erosion);
    }
};

TEST(MobilityStory, OfAnErosionIsOfTheSoilBeforeFinesLeftUpToTheHighestGradient) {
    const Ramps late({{0.1, 0}, {0.5, 3}, {1, 5}});
    EXPECT_EQ(mobility_of(late.stages.front())->ramp.back().gradient, 0.5);
    EXPECT_EQ(specified_gradient(late.stages.front()), std::nullopt) << "the erosion goes on to 1";
    const MobilityStory story = gather_mobility(late.stages).front();
    EXPECT_EQ(story.specified_gradient, std::nullopt);
    EXPECT_EQ(story.safety.seeds, 0);
    EXPECT_FALSE(story.safety_at_least);
}

TEST(MobilityStory, OfOneGradientHasThatToBear) {
    const Ramps same({{0.2, 3}, {0.2, 1}});
    EXPECT_EQ(mobility_of(same.stages.front()), &*same.stages.front().findings.erosion->passes.front().mobility);
    EXPECT_EQ(gather_mobility(same.stages).front().specified_gradient, 0.2);
}

} // namespace
} // namespace suffuse::study
