#include "suffuse/answer/report_answer.hpp"

#include "suffuse/answer/erosion_table.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::answer {
namespace {

study::RunResults
results_of(const std::vector<record::FinishedStage>& stages, std::vector<study::StrengthChange> strength = {}) {
    study::RunResults results;
    results.stages = stages;
    results.story = study::find_story(results.stages);
    results.strength = std::move(strength);
    return results;
}

nlohmann::json response(double peak, double strain) {
    return {{"response", {{"peak_deviator", peak}, {"peak_strain", strain}}}};
}

TEST(ReportAnswer, ReportsTestsOfStrengthAndNotThoseThatLeadToAState) {
    casefile::Study study;
    const casefile::Stage state{.name = "deviatoric", .spec = triaxial::TriaxialSpec{.stress_ratio = 0.75}};
    const casefile::Stage test{.name = "shear", .spec = triaxial::TriaxialSpec{}};
    // As a program wrote them that did not look for lost confinement yet.
    const std::vector<record::FinishedStage> stages = {
        {&study, nullptr, &state, response(100e3, 0.001), {}}, {&study, nullptr, &test, response(320e3, 0.02), {}}};
    EXPECT_EQ(
        answer_of_erosion(results_of(stages)),
        std::vector<std::string>{
            "Highest deviator stress in triaxial compression: 320 kPa at 2 % axial strain in “shear”."}
    );
}

TEST(ReportAnswer, ReportsTheTestsOfASweepWhereTheyAreFew) {
    casefile::Study study;
    study.name = "orders";
    study.sweep = {{"stage.removed.order", {"random", "smallest"}}};
    const casefile::Stage test{.name = "shear", .spec = triaxial::TriaxialSpec{}};
    std::vector<casefile::Variant> variants(5);
    const std::vector<std::string> orders = {"random", "smallest", "a", "b", "c"};
    std::vector<record::FinishedStage> stages;
    for (std::size_t k = 0; k < variants.size(); ++k) {
        variants[k].values = {{"stage.removed.order", orders[k]}, {"fines_content", orders[k]}};
        stages.push_back({&study, &variants[k], &test, response(100e3 * static_cast<double>(k + 1), 0.02), {}});
    }
    EXPECT_TRUE(answer_of_erosion(results_of(stages)).empty()) << "five are a table";
    stages.resize(4);
    EXPECT_EQ(answer_of_erosion(results_of(stages)).size(), 1U);
    stages.resize(2);
    EXPECT_EQ(
        answer_of_erosion(results_of(stages)),
        std::vector<std::string>{
            "Highest deviator stress in triaxial compression: 100 kPa at 2 % axial strain in “shear” "
            "with order random, 200 kPa at 2 % axial strain in “shear” with order smallest."}
    );
    study.sweep.front().key = "fines_content"; // a curve
    EXPECT_TRUE(answer_of_erosion(results_of(stages)).empty());
}

TEST(ReportAnswer, ReportsATestOnceWhereItIsComparedWithAnother) {
    casefile::Study study;
    const casefile::Stage before{.name = "before", .spec = triaxial::TriaxialSpec{}};
    const casefile::Stage after{.name = "after", .spec = triaxial::TriaxialSpec{}};
    casefile::Variant variant;
    study::StrengthChange change;
    change.study = &study, change.variant = &variant, change.before = &before, change.after = &after;
    const std::vector<record::FinishedStage> stages = {
        {&study, nullptr, &before, response(400e3, 0.02), {}}, {&study, nullptr, &after, response(300e3, 0.02), {}}};
    const std::vector<std::string> answer = answer_of_erosion(results_of(stages, {change}));
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_TRUE(answer.front().starts_with("Strength, “after” against “before”")) << answer.front();
}

/// An erosion of one pass.
record::FinishedStage erosion_of(const casefile::Variant& variant, const casefile::Stage& stage, std::int64_t removed) {
    erosion::ErosionResult erosion;
    erosion::PassResult& pass = erosion.passes.emplace_back();
    pass.pass = 1;
    pass.detachable = 39;
    pass.removed = removed;
    pass.eroded_mass_percent_of_initial = static_cast<double>(removed);
    return {nullptr, &variant, &stage, {}, {.probes = {}, .erosion = erosion, .curve = {}, .throat_flux = {}}};
}

TEST(ReportAnswer, IsBriefOfAPassThatTookNothingButForAnUnusualReason) {
    casefile::Variant variant;
    variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
    std::vector<record::FinishedStage> stages = {erosion_of(variant, variant.stages[1], 0)};
    erosion::Ending& ending = stages.front().findings.erosion->passes.front().verdict;
    const std::string brief = "Pass 1: none of 39 detachable fines was carried out.";
    ending = {erosion::NothingLeaves{}};
    EXPECT_EQ(answer_of_erosion(results_of(stages)), std::vector<std::string>{brief});
    ending = {erosion::NoiseDecides{}};
    EXPECT_EQ(
        answer_of_erosion(results_of(stages)),
        std::vector<std::string>{
            brief + " It ended there: the fines that leave cannot be distinguished from the twin's noise."}
    );
}

TEST(ReportAnswer, SaysThatGrainsWithoutLoadLeaveUnderAnyGradient) {
    casefile::Study study;
    casefile::Variant variant;
    variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
    std::vector<record::FinishedStage> stages = {erosion_of(variant, variant.stages[1], 3)};
    stages.front().study = &study;
    erosion::PassResult& pass = stages.front().findings.erosion->passes.front();
    pass.probe.id = {7};
    const auto reported = [&] { return fmt::format("{}", fmt::join(answer_of_erosion(results_of(stages)), " ")); };
    pass.coordination_histogram = {{0, 2}, {1, 1}};
    EXPECT_NE(reported().find("None of them carried load: without gravity"), std::string::npos) << reported();
    pass.coordination_histogram = {{0, 2}, {2, 1}};
    EXPECT_EQ(reported().find("carried load"), std::string::npos) << reported();
    pass.coordination_histogram = {{0, 98}, {2, 2}};
    EXPECT_NE(reported().find("Only 2 of the 100 carried load"), std::string::npos) << reported();
    pass.coordination_histogram = {{0, 97}, {2, 3}};
    EXPECT_EQ(reported().find("carried load"), std::string::npos) << reported();
    pass.coordination_histogram = {{0, 2}, {1, 1}};
    stages.front().findings.erosion->ledger.push_back({7, 1, 1e-4, 1e-9, 0, erosion::Reason::Forced});
    EXPECT_EQ(reported().find("carried load"), std::string::npos) << "what leaves by force needs no water";
    EXPECT_NE(reported().find("Pass 1: 3 fines were taken out by force, 3.00 % of"), std::string::npos) << reported();
    EXPECT_NE(reported().find("Question: how removing fines of the soil"), std::string::npos) << reported();
    pass.removed = 1;
    EXPECT_NE(reported().find("Pass 1: 1 fine grain was taken out by force, "), std::string::npos) << reported();
}

TEST(ReportAnswer, NamesTheGradientOfEachPassWhereTheyDiffer) {
    casefile::Study study;
    casefile::Variant variant;
    variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
    std::vector<record::FinishedStage> stages = {erosion_of(variant, variant.stages[1], 3)};
    stages.front().study = &study;
    auto& passes = stages.front().findings.erosion->passes;
    passes.front().probe.id = {7}, passes.front().probe.gradient = 0.1;
    passes.front().coordination_histogram = {{0, 3}};
    passes.push_back(passes.front());
    passes.back().pass = 2, passes.back().probe.gradient = 0.5;
    const std::string text = fmt::format("{}", fmt::join(answer_of_erosion(results_of(stages)), " "));
    EXPECT_NE(text.find("gradients of i = 0.1 to 0.5 detach, and how 2 passes"), std::string::npos) << text;
    EXPECT_NE(text.find("Pass 2 at i = 0.5: 3 of 39 detachable"), std::string::npos) << text;
    EXPECT_NE(text.find("so that these gradients are not critical"), std::string::npos) << text;
    EXPECT_EQ(tabulate_erosions({stages.front(), stages.front()})->rows.front()[1], "0.1 to 0.5");
}

TEST(ReportAnswer, CallsANegativeLossOfStressAGain) {
    casefile::Variant variant;
    variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
    std::vector<record::FinishedStage> stages = {erosion_of(variant, variant.stages[1], 3)};
    erosion::PassResult& pass = stages.front().findings.erosion->passes.front();
    pass.stress_before = diagonal({1e5, 1e5, 1e5}), pass.stress_constant_volume = 1.03 * pass.stress_before;
    const std::string text = answer_of_erosion(results_of(stages)).front();
    EXPECT_NE(text.find("at constant volume the skeleton gained 3.00 % of its mean stress"), std::string::npos) << text;
}

TEST(ReportAnswer, ReportsHowMuchOfACutSoilTheSampleRepresents) {
    casefile::Variant variant;
    grains::Soil& soil = variant.soil.emplace();
    soil.measured = {{1e-4, 1e-3, 1e-2}, {0, 0.25, 1}, "invented"};
    soil.whole = grains::part_between(*soil.measured, 1e-4, 1e-3);
    variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
    const std::vector<record::FinishedStage> stages = {erosion_of(variant, variant.stages[1], 0)};
    const std::vector<std::string> answer = answer_of_erosion(results_of(stages));
    EXPECT_EQ(
        answer.front(), "Only its grains from 0.1 to 1 mm are in the sample, 25 % of its mass: 0 % are finer, 75 % "
                        "coarser. All that follows is of that part."
    );
}

TEST(ReportAnswer, ReportsManyPassesInTwoSentencesAndHowOftenFinesWereHeld) {
    casefile::Variant variant;
    variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
    std::vector<record::FinishedStage> stages = {erosion_of(variant, variant.stages[1], 3)};
    auto& passes = stages.front().findings.erosion->passes;
    erosion::Transport& transport = passes.front().transport;
    transport.distance = 4e-3;
    transport.id = {1, 2};
    transport.mass = {1, 1};
    transport.travel = {1e-3, 4e-3};
    transport.fate = {erosion::Fate::Lodged, erosion::Fate::Left};
    for (int pass = 2; pass <= 6; ++pass) {
        passes.push_back(passes.front());
        passes.back().pass = pass;
    }
    const std::vector<std::string> answer = answer_of_erosion(results_of(stages));
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_TRUE(answer.front().starts_with("Pass 1: 3 of 39")) << answer.front();
    EXPECT_EQ(answer.front().find("Pass 2:"), std::string::npos) << answer.front();
    EXPECT_NE(answer.front().find("Passes 2 to 6: 15 fines were carried out, 15.00 %"), std::string::npos)
        << answer.front();
    EXPECT_NE(
        answer.front().find("A mm of flow held a detached grain 0.2 times in pass 1, 0.2 times in pass 6"),
        std::string::npos
    ) << answer.front();
}

TEST(ReportAnswer, ReportsOneErosionOfManyAndTheRangeOfAll) {
    casefile::Study study;
    study.name = "second";
    casefile::Variant variant;
    variant.stages = {
        {.name = "initial"},
        {.name = "base", .parent = 0},
        {.name = "b", .parent = 0},
        {.name = "c", .parent = 0},
        {.name = "d", .parent = 0}};
    std::vector<record::FinishedStage> stages;
    for (std::size_t k = 1; k < variant.stages.size(); ++k) {
        stages.push_back(erosion_of(variant, variant.stages[k], static_cast<std::int64_t>(k)));
        stages.back().study = &study;
    }
    const std::vector<std::string> answer = answer_of_erosion(results_of(stages));
    ASSERT_EQ(answer.size(), 2U);
    EXPECT_EQ(
        answer[0],
        "4 erosions removed 1.00 to 4.00 % of the mass (table “All erosions”); the following describes second, base."
    );
    EXPECT_TRUE(answer[1].starts_with("“base”: Pass 1: 1 of 39 detachable fines was carried out, 1.00 % of"))
        << answer[1];
}

TEST(ReportAnswer, ReportsARemovalInWordsOverItsSeeds) {
    casefile::Study study;
    study.name = "orders";
    study.replicates = 2;
    study.sweep = {{"stage.removed.order", {"random"}}};
    const casefile::Stage removal{.name = "removed", .spec = erosion::RemoveSpec{.passes = 2}};
    std::vector<casefile::Variant> seeds(2);
    const auto numbers = [](int removed, double strain, bool failed) {
        return nlohmann::json{
            {"removed", removed},
            {"passes", {nullptr, nullptr}},
            {"removed_mass_share", 0.15},
            {"volumetric_strain", strain},
            {"failed", failed}};
    };
    std::vector<record::FinishedStage> stages = {
        {&study, &seeds[0], &removal, numbers(571, -0.01, false), {}},
        {&study, &seeds[1], &removal, numbers(1654, -0.03, true), {}}};
    seeds[0].values = seeds[1].values = {{"stage.removed.order", std::string("random")}};
    EXPECT_EQ(
        answer_of_erosion(results_of(stages)),
        std::vector<std::string>{
            "orders, removed, order random (2 samples): 571 to 1,654 fines taken out in 2 passes, 15 % of the mass; "
            "under the stresses held before the skeleton strained by −2 ± 1.4 % in volume, and failed in 1 of them."}
    );
    stages = {{&study, seeds.data(), &removal, numbers(1, 1e-6, false), {}}};
    EXPECT_NE(answer_of_erosion(results_of(stages)).front().find(": 1 fine grain taken out"), std::string::npos);
    stages = {{&study, seeds.data(), &removal, numbers(571, 1e-6, false), {}}};
    EXPECT_EQ(
        answer_of_erosion(results_of(stages)),
        std::vector<std::string>{
            "orders, removed, order random: 571 fines taken out in 2 passes, 15 % of the mass; under the stresses held "
            "before the skeleton strained by less than 0.01 % in volume."}
    );
}

TEST(ReportAnswer, IsOfTheFirstSampleThatHasFines) {
    casefile::Study study;
    study.name = "s";
    std::vector<casefile::Variant> variants(2);
    std::vector<record::FinishedStage> stages;
    for (casefile::Variant& variant : variants) {
        variant.stages = {{.name = "initial"}, {.name = "erosion", .parent = 0}};
        stages.push_back(erosion_of(variant, variant.stages[1], 0));
        stages.back().study = &study;
    }
    EXPECT_EQ(study::find_story(stages).eroded, stages.data()) << "none has: the first";
    stages.back().findings.erosion->passes.front().probe.id = {7};
    EXPECT_EQ(study::find_story(stages).eroded, &stages.back());
    EXPECT_TRUE(study::find_story(stages).others.empty()) << "another sample";
}

TEST(ReportAnswer, CountsWhatIsDetachableByTheRuleThatTheStageSpecifies) {
    casefile::Study study;
    const casefile::Variant variant;
    casefile::Stage stage{.name = "probe", .spec = erosion::DetachStageSpec{}};
    erosion::ProbeResult probe;
    probe.gradient = 0.05;
    probe.id = {1, 2, 3};
    probe.by_velocity = {1, 1, 0}, probe.by_displacement = {1, 0, 0};
    const std::vector<record::FinishedStage> stages = {
        {&study, &variant, &stage, nlohmann::json::object(), {{probe}, {}, {}, {}}}};
    const auto reported = [&] { return answer_of_erosion(results_of(stages)).front(); };
    EXPECT_EQ(reported(), "Of 3 fines 2 at the gradient i = 0.05 are detachable.");
    std::get<erosion::DetachStageSpec>(stage.spec).detached.by = erosion::DetachBy::Displacement;
    EXPECT_EQ(reported(), "Of 3 fines 1 at the gradient i = 0.05 are detachable, by their displacement.");
}

TEST(ReportAnswer, SaysThatTheGradientDoesNotMatterWhereTenTimesTheGradientDetachesTheSameToAFiftieth) {
    casefile::Study study;
    const casefile::Variant variant;
    const casefile::Stage stage{.name = "probe", .spec = erosion::DetachStageSpec{}};
    const auto few_moving = [&](double gradient, std::size_t fewer) {
        std::vector<erosion::ProbeResult> probes(2);
        for (std::size_t k = 0; k < probes.size(); ++k) {
            probes[k].gradient = k == 0 ? 0.05 : gradient;
            probes[k].id.resize(200);
            probes[k].by_velocity.assign(200, 0);
            std::fill_n(probes[k].by_velocity.begin(), k == 0 ? 100 - fewer : 100, std::uint8_t{1});
        }
        const std::vector<record::FinishedStage> stages = {
            {&study, &variant, &stage, nlohmann::json::object(), {probes, {}, {}, {}}}};
        return answer_of_erosion(results_of(stages)).front().find("does not depend measurably") != std::string::npos;
    };
    EXPECT_TRUE(few_moving(0.501, 2));
    EXPECT_FALSE(few_moving(0.501, 3));
    EXPECT_FALSE(few_moving(0.499, 2));
}

} // namespace
} // namespace suffuse::answer
