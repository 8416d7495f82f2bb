#include "suffuse/plan/plan.hpp"

#include <gtest/gtest.h>

#include <string>

namespace suffuse::plan {
namespace {

/// Three fines contents of two samples each, refined by three values a side of the lowest point of two curves.
casefile::Case refined_case() {
    casefile::Case what;
    casefile::Study& study = what.studies.emplace_back();
    study.name = "dam";
    study.replicates = 2;
    study.sweep = {{"fines_content", {0.1, 0.2, 0.3}}};
    study.refine = {.key = "fines_content", .of = "void_ratio", .at = {"loose", "dense"}, .add = 3};
    study.variants.resize(6);
    for (std::size_t k = 0; k < study.variants.size(); ++k) {
        study.variants[k].folder = "dam/" + std::to_string(k);
    }
    return what;
}

/// Samples of 1 to 2 s, 2 to 4 s and so on.
RunPlan plan_of(const casefile::Case& what) {
    RunPlan plan;
    for (const casefile::Variant& variant : what.studies.front().variants) {
        StageEstimate& stage = plan.stages.emplace_back();
        stage.study = variant.folder;
        const auto number = static_cast<double>(plan.stages.size());
        stage.seconds = {number, 2 * number};
    }
    return plan;
}

TEST(PlanRefined, CountsSamplesOnOneSideOfOneExtremeUpToBothSidesOfEach) {
    const casefile::Case what = refined_case();
    RunPlan plan = plan_of(what);
    const RefinedEstimate refined = price_refined(plan, what);
    EXPECT_EQ(refined.samples.least, 3 * 2);
    EXPECT_EQ(refined.samples.most, 3 * 2 * 2 * 2);
    EXPECT_EQ(refined.seconds.least, 1) << "as dear as the cheapest sample";
    EXPECT_EQ(refined.seconds.most, 12) << "to as dear as the dearest";
    plan.stages.front().seconds = {};
    EXPECT_EQ(price_refined(plan, what).seconds.least, 2) << "one that is there already has no price";
}

TEST(PlanRefined, SamplesSideBySideTakeAtLeastAsLongAsOne) {
    const RefinedEstimate refined{{6, 24}, {1, 12}};
    EXPECT_DOUBLE_EQ(seconds_of_refined(refined, 4).least, 1.5);
    EXPECT_DOUBLE_EQ(seconds_of_refined(refined, 4).most, 6 * 12);
    EXPECT_DOUBLE_EQ(seconds_of_refined(refined, 8).least, 1);
    EXPECT_EQ(seconds_of_refined({}, 8).most, 0);
}

} // namespace
} // namespace suffuse::plan
