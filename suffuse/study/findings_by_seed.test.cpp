#include "suffuse/study/findings_by_seed.hpp"

#include <gtest/gtest.h>

namespace suffuse::study {
namespace {

erosion::ProbeResult probe_of(std::size_t fines) {
    erosion::ProbeResult probe;
    probe.gradient = 0.05;
    probe.id.resize(fines);
    for (std::uint32_t k = 0; k < fines; ++k) {
        probe.id[k] = k;
    }
    probe.diameter.resize(fines, 1e-4), probe.fluid_force.resize(fines, 1e-9), probe.coordination.resize(fines, 0);
    probe.speed.resize(fines), probe.twin_speed.resize(fines), probe.displacement.resize(fines);
    probe.free_speed.resize(fines, 1), probe.free_displacement.resize(fines, 1);
    probe.by_velocity.resize(fines, 1), probe.by_displacement.resize(fines, 1);
    return probe;
}

TEST(FindingsBySeed, AreOfTheFirstSampleThatHasFines) {
    casefile::Study study;
    std::vector<casefile::Variant> variants(2);
    variants[0].values = {{"fines_content", "0 %"}}, variants[1].values = {{"fines_content", "20 %"}};
    const casefile::Stage stage{.name = "probed", .spec = erosion::DetachStageSpec{}};
    std::vector<record::FinishedStage> stages = {
        {&study, &variants[0], &stage, {}, {}}, {&study, &variants[1], &stage, {}, {}}};
    stages[0].findings.probes = {probe_of(0)};
    EXPECT_TRUE(judge_erosion_by_seed(stages).empty());
    stages[1].findings.probes = {probe_of(3)};
    for (const int replicates : {1, 2}) {
        study.replicates = replicates;
        study.variants = variants;
        stages[0].variant = study.variants.data(), stages[1].variant = &study.variants[1];
        const std::vector<Finding> found = judge_erosion_by_seed(stages);
        const std::vector<Finding> expected = judge_erosion(stages[1].findings.probes, {});
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_EQ(found[k].ours, expected[k].ours) << replicates;
            EXPECT_EQ(found[k].met, expected[k].met) << replicates;
        }
    }
}

} // namespace
} // namespace suffuse::study
