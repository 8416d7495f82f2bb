#include "suffuse/answer/filter_words.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace suffuse::answer {
namespace {

/// Samples of one stage each.
struct FilterRun {
    casefile::Study study;
    casefile::Variant variant;
    casefile::Stage stage{.name = "flow", .spec = erosion::MigrateSpec{}};
    std::vector<record::FinishedStage> stages;

    FilterRun() {
        study.name = "s";
        study.replicates = 1;
    }

    void add(double eroded, bool ended, double overlap = 0.01) {
        erosion::MigrationResult result;
        result.rows = {{.time = 0.4}};
        result.holds = {
            {.gradient = 1, .held_for = 0.1, .ended = false}, // an earlier cut decides nothing
            {.gradient = 5,
             .held_for = 0.3,
             .ended = ended,
             .eroded_mass_share = eroded,
             .moving_mass_share = ended ? 0.0 : 0.71,
             .entered_mass_share = 0.57,
             .depth = 1.5e-3}};
        result.filter = {.filter_d15 = 0.93e-3, .base_d85 = 0.31e-3, .passed = eroded, .constriction = 0.2e-3};
        const nlohmann::json numbers = {
            {"largest_overlap", overlap}, {"mean_stress", 20e3}, {"stack", {{"base_stress", 12.0}}}};
        stages.push_back({&study, &variant, &stage, numbers, {.migration = result}});
    }
};

TEST(FilterWords, JudgeByWhatLeftAndWhetherMotionEnded) {
    const std::vector<std::tuple<double, bool, FilterVerdict>> cases = {
        {0, true, FilterVerdict::Holds},        {0.05, true, FilterVerdict::HoldsAfterLoss},
        {0.051, true, FilterVerdict::LetsPass}, {1, true, FilterVerdict::LetsPass}, // all of it
        {0, false, FilterVerdict::Undecided},   {0.05, false, FilterVerdict::Undecided},
        {0.051, false, FilterVerdict::LetsPass}};
    for (const auto& [eroded, ended, expected] : cases) {
        EXPECT_EQ(judge_filter(eroded, ended), expected) << eroded << ended;
    }
}

TEST(FilterWords, OfABaseWithAGapSayThatTheGrainsBelowItCount) {
    FilterRun run;
    run.add(0.28, true);
    run.stages[0].findings.migration->filter.base_gap = 0.1e-3;
    EXPECT_NE(
        filter_verdict(filter_stages(run.stages)).front().find("28 % of the grains below its gap passed"),
        std::string::npos
    );
    EXPECT_NE(
        filter_headlines(filter_stages(run.stages)).front().detail.find("below the base's gap"), std::string::npos
    );
}

TEST(FilterWords, AnswerInASentenceOfTwentyWordsAStage) {
    FilterRun run;
    run.add(0, true);
    run.add(0, false);
    const std::vector<std::string> sentences = filter_verdict(filter_stages(run.stages));
    ASSERT_EQ(sentences.size(), 2U);
    EXPECT_EQ(
        sentences[0], "At D15/d85 = 3 the filter holds: nothing passed, the base came 1.5 mm deep, and motion ended."
    );
    EXPECT_EQ(
        sentences[1],
        "At D15/d85 = 3 this run does not decide: nothing passed, the base came 1.5 mm deep, and 71 % still moves."
    );
    run.add(0.27, false);
    run.add(0.01, true);
    const std::vector<std::string> many = filter_verdict(filter_stages(run.stages));
    ASSERT_EQ(many.size(), 2U);
    EXPECT_EQ(many[0], "The filter holds in 1 of 4 samples.");
    EXPECT_EQ(many[1], "It holds after a loss in 1, lets the base pass in 1, and 1 are not decided.");
}

TEST(FilterWords, NameTheLargestDoubtFirstAndWhatRemovesIt) {
    FilterRun run;
    run.add(0, true, 0.25);
    const std::vector<std::string> one = filter_doubts(filter_stages(run.stages));
    ASSERT_EQ(one.size(), 3U);
    EXPECT_NE(one[0].find("overlapped by up to 25 % of a radius"), std::string::npos) << one[0];
    EXPECT_NE(one[1].find("`--set study.s.replicates=3`"), std::string::npos) << one[1];
    EXPECT_NE(one[2].find("bears 12 Pa, and not the 20 kPa"), std::string::npos) << one[2];
    run.add(0, false);
    const std::vector<std::string> cut = filter_doubts(filter_stages(run.stages));
    EXPECT_NE(cut[0].find("`--set 'study.s.stage.flow.hold_at_most=1.2 s'`"), std::string::npos) << cut[0];
    std::get<erosion::MigrateSpec>(run.stage.spec).time_at_most = 0.3;
    run.stages.back().findings.migration->holds.back().ended_by = erosion::HoldEnd::TimeLimit;
    EXPECT_NE(filter_doubts(filter_stages(run.stages))[0].find("time_at_most=1.2 s'`"), std::string::npos);
    run.study.replicates = 3;
    FilterRun good;
    good.study.replicates = 3;
    good.add(0, true);
    EXPECT_EQ(filter_doubts(filter_stages(good.stages)).size(), 1U) << "the stress alone";
}

TEST(FilterWords, HaveARowForEachStackAndNoneForOneSoil) {
    FilterRun run;
    run.add(0.012, false);
    FilterRun other;
    other.add(0, true);
    other.stages[0].findings.migration->filter = {};
    EXPECT_FALSE(tabulate_filters(other.stages));
    run.stages.push_back(other.stages[0]);
    const figures::PageTable table = *tabulate_filters(run.stages);
    EXPECT_EQ(table.section, "Filter");
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_EQ(table.rows[0].size(), table.header.size());
    EXPECT_EQ(table.rows[0][3], "0.4, cut");
    EXPECT_EQ(table.rows[0][4], "1.2 %");
    EXPECT_EQ(table.rows[0][8], "0.22");
    EXPECT_EQ(table.rows[0].back(), "this run does not decide");
    EXPECT_NE(table.note.find("this run does not decide: 1.2 % passed"), std::string::npos) << table.note;
    EXPECT_NE(table.note.find("The largest doubts: Motion had not ended after 0.3 s"), std::string::npos);
    const std::vector<Headline> cards = filter_headlines(filter_stages(run.stages));
    ASSERT_EQ(cards.size(), 1U);
    EXPECT_EQ(cards[0].value, "1.2 %");
    EXPECT_EQ(cards[0].lead, "at least");
}

} // namespace
} // namespace suffuse::answer
