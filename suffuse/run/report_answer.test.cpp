#include "suffuse/run/report_answer.hpp"

#include <gtest/gtest.h>

namespace suffuse::run {
namespace {

nlohmann::json response(double peak, double strain) {
    return {{"response", {{"peak_deviator", peak}, {"peak_strain", strain}}}};
}

TEST(ReportAnswer, TellsTestsOfStrengthAndNotThoseThatLeadToAState) {
    casefile::Study study;
    const casefile::Stage state{.name = "deviatoric", .spec = triaxial::TriaxialSpec{.stress_ratio = 0.75}};
    const casefile::Stage test{.name = "shear", .spec = triaxial::TriaxialSpec{}};
    // As a program wrote them that did not look for lost confinement yet.
    const std::vector<FinishedStage> stages = {
        {&study, nullptr, &state, response(100e3, 0.001), {}}, {&study, nullptr, &test, response(320e3, 0.02), {}}};
    EXPECT_EQ(
        answer_of_erosion({}, stages, {}),
        std::vector<std::string>{
            "Highest deviator stress in triaxial compression: 320 kPa at 2 % axial strain in shear."}
    );
}

TEST(ReportAnswer, TellsATestOnceWhereItIsComparedWithAnother) {
    casefile::Study study;
    const casefile::Stage before{.name = "before", .spec = triaxial::TriaxialSpec{}};
    const casefile::Stage after{.name = "after", .spec = triaxial::TriaxialSpec{}};
    casefile::Variant variant;
    StrengthChange change;
    change.study = &study, change.variant = &variant, change.before = &before, change.after = &after;
    const std::vector<FinishedStage> stages = {
        {&study, nullptr, &before, response(400e3, 0.02), {}}, {&study, nullptr, &after, response(300e3, 0.02), {}}};
    const std::vector<std::string> answer = answer_of_erosion({}, stages, {change});
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_TRUE(answer.front().starts_with("Strength, after against before")) << answer.front();
}

} // namespace
} // namespace suffuse::run
