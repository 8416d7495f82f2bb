#include "suffuse/answer/migration_words.hpp"

#include <gtest/gtest.h>

namespace suffuse::answer {
namespace {

/// Samples of one stage each.
struct MigrationRun {
    casefile::Study study;
    casefile::Variant variant;
    casefile::Stage stage{.name = "wash", .spec = erosion::MigrateSpec{}};
    std::vector<record::FinishedStage> stages;

    MigrationRun() {
        study.name = "s";
        study.replicates = 1;
    }

    void add(double eroded, bool ended, double overlap = 0.01, double fed_mass = 0) {
        erosion::MigrationResult result;
        result.fines_mass = 1e-6;
        result.rows = {{.time = 3, .fed_mass = fed_mass}};
        result.holds = {
            {.gradient = 0.2, .held_for = 1, .ended = false}, // an earlier cut decides nothing
            {.gradient = 0.6,
             .held_for = 2,
             .ended = ended,
             .eroded_mass_share = eroded,
             .moving_mass_share = ended ? 0.0 : 0.12,
             .permeability = 1e-10}};
        const nlohmann::json numbers = {
            {"largest_overlap", overlap}, {"permeability_before", 1e-10}, {"permeability_after", 1.2e-10}};
        stages.push_back({&study, &variant, &stage, numbers, {.migration = result}});
    }

    [[nodiscard]] FinishedStages found() const { return migration_stages(stages); }
};

TEST(MigrationWords, SayWhatLeftAtWhichGradientAndWhetherMotionEnded) {
    MigrationRun run;
    run.add(0.14, false);
    EXPECT_EQ(
        migration_verdict(run.found()).front(),
        "Water up to i = 0.6 carries out 14 % of the fines in 3 s; 12 % still move at the end."
    );
    std::get<erosion::MigrateSpec>(run.stage.spec).still_for = 2; // as long as the hold
    EXPECT_EQ(
        migration_verdict(run.found()).front(),
        "Water up to i = 0.6 carries out 14 % of the fines in 3 s; 12 % moved, in a hold too short to see motion end."
    );
    MigrationRun still;
    still.add(0, true);
    EXPECT_EQ(
        migration_verdict(still.found()).front(),
        "Water up to i = 0.6 carries out none of the fines in 3 s; motion ended."
    );
}

TEST(MigrationWords, OfSeveralStagesNameThemAndOfManySayTheRange) {
    MigrationRun run;
    run.add(0.14, false);
    run.add(0.02, true);
    const std::vector<std::string> two = migration_verdict(run.found());
    ASSERT_EQ(two.size(), 2U);
    EXPECT_NE(two[0].find("wash: water"), std::string::npos) << two[0];
    run.add(0.05, true);
    run.add(0.3, true);
    const std::vector<std::string> many = migration_verdict(run.found());
    EXPECT_EQ(many[0], "Water carries out 2.0 % to 30 % of the fines in 4 simulations.");
    EXPECT_EQ(many[1], "In 1 of them fines still moved at the end.");
}

TEST(MigrationWords, CountFinesThatEnteredAmongAll) {
    MigrationRun run;
    run.add(1.5, true, 0.01, 2e-6); // three times as many fines as there were before
    EXPECT_NE(migration_verdict(run.found()).front().find("50 % of the fines"), std::string::npos);
}

TEST(MigrationWords, NameTheGrainThatPassedMostThroatsAndItsWay) {
    MigrationRun run;
    run.add(0.14, false);
    const auto note = [&] { return tabulate_migrations(run.stages)->note; };
    EXPECT_EQ(note().find("farthest way"), std::string::npos) << "no grain has passed a throat";
    erosion::GrainStory& story = run.stages.front().findings.migration->story;
    story = {
        .id = 523,
        .diameter = 0.19e-3,
        .departed = 1.2,
        .gradient = 0.4,
        .way = 3.1e-3,
        .throats = 14,
        .narrowest = 0.21e-3,
        .holders = {12, 88}};
    EXPECT_NE(
        note().find("grain 523, 0.19 mm wide, left its place under i = 0.4 after 1.2 s. It passed 14 throats, the "
                    "narrowest 0.21 mm wide, and went 3.1 mm. It came to rest at grains 12, 88."),
        std::string::npos
    ) << note();
    story.left = 1.9;
    EXPECT_NE(note().find("It left after 1.9 s."), std::string::npos) << note();
}

TEST(MigrationWords, DoubtMotionThatHasNotEndedFirst) {
    MigrationRun run;
    run.add(0.14, false, 0.1);
    const std::vector<std::string> doubts = migration_doubts(run.found());
    ASSERT_EQ(doubts.size(), 2U);
    EXPECT_NE(doubts[0].find("a lower bound"), std::string::npos);
    EXPECT_NE(doubts[1].find("`softness`"), std::string::npos);
    MigrationRun good;
    good.add(0.14, true);
    EXPECT_TRUE(migration_doubts(good.found()).empty());
}

TEST(MigrationWords, AdviseToRaiseTheLimitThatCutTheLastHold) {
    using erosion::HoldEnd;
    const auto advice = [](HoldEnd end, const erosion::MigrateSpec& spec) {
        MigrationRun run;
        run.stage.spec = spec;
        run.add(0.14, false); // held for 2 of 3 s
        run.stages.back().findings.migration->holds.back().ended_by = end;
        const std::string doubt = migration_doubts(run.found()).front();
        return doubt.substr(doubt.find("wash.") + 5);
    };
    EXPECT_EQ(advice(HoldEnd::HoldLimit, {.hold_at_most = 2}), "hold_at_most=8 s'`.");
    EXPECT_EQ(advice(HoldEnd::HoldLimit, {.hold_at_most = 2, .time_at_most = 9}), "hold_at_most=8 s'`.");
    EXPECT_EQ(advice(HoldEnd::TimeLimit, {.hold_at_most = 5, .time_at_most = 3}), "time_at_most=12 s'`.");
    EXPECT_EQ(advice(HoldEnd::StepLimit, {.hold_at_most = 5, .steps_at_most = 1000}), "steps_at_most=4000'`.");
}

TEST(MigrationWords, OnACardMarkALowerBound) {
    MigrationRun run;
    run.add(0.14, false);
    const Headline card = migration_headlines(run.found()).front();
    EXPECT_EQ(card.value, "14 %");
    EXPECT_EQ(card.lead, "at least");
    EXPECT_NE(card.detail.find("permeability × 1.2"), std::string::npos) << card.detail;
}

TEST(MigrationWords, HaveARowAGradientInTheirTable) {
    MigrationRun run;
    EXPECT_FALSE(tabulate_migrations(run.stages));
    run.add(0.14, false);
    const figures::PageTable table = *tabulate_migrations(run.stages);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[1].back(), "cut");
}

TEST(MigrationWords, AreNotThoseOfAFilter) {
    MigrationRun run;
    run.add(0.14, true);
    run.stages[0].findings.migration->filter.filter_d15 = 1e-3;
    EXPECT_TRUE(run.found().empty());
}

} // namespace
} // namespace suffuse::answer
