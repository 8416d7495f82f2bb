#include "apps/terminal.hpp"

#include <gtest/gtest.h>

#include "apps/wording.hpp"
#include <algorithm>

namespace suffuse::apps {
namespace {

run::Progress somewhere() {
    run::Progress progress;
    progress.study = "fines-sweep/fc=20/rep=1";
    progress.stage = "shear";
    progress.verb = "triaxial";
    progress.stage_number = 2;
    progress.stages = 3;
    progress.part = "shear";
    progress.steps = 12'345;
    progress.stage_seconds = 60;
    progress.particle_steps_per_second = 2.31e7;
    progress.state = {{"void_ratio", 0.6713}, {"mean_stress", 99.8e3}, {"axial_strain", 0.114}, {"odd", "text"}};
    return progress;
}

/// Three stages, 100 to 200 s each.
run::RunPlan three_stages() {
    run::RunPlan plan;
    plan.stages.resize(3);
    for (run::StageEstimate& stage : plan.stages) {
        stage.seconds = {100, 200};
    }
    return plan;
}

/// What a view writes, for one way of calling it.
class Written {
public:
    explicit Written(bool redraws, bool quiet = false)
        : view(
              {redraws, true, quiet, [] { return std::size_t{80}; }, [this](const std::string& t) { text += t; }},
              three_stages(), "hint"
          ) {}

    [[nodiscard]] std::ptrdiff_t lines() const { return std::count(text.begin(), text.end(), '\n'); }

    std::string text;
    ProgressView view;
};

TEST(Terminal, NoLineIsWiderThanTheTerminal) {
    for (const std::size_t width : {1U, 10U, 40U, 80U, 200U}) {
        const auto lines =
            progress_lines(somewhere(), {60, 120}, "Ctrl-C saves; suffuse resume runs/x-0001", width, true);
        EXPECT_GE(lines.size(), 3U);
        EXPECT_LE(lines.size(), 6U);
        for (const std::string& line : lines) {
            EXPECT_LE(columns_of(line), width) << line;
        }
    }
}

TEST(Terminal, AWideOneShowsEverythingThatMatters) {
    std::string text;
    for (const std::string& line : progress_lines(somewhere(), {60, 120}, "the hint", 200, true)) {
        text += line + "\n";
    }
    for (const std::string part :
         {"fines-sweep/fc=20/rep=1/shear", "12,345", "1/3", "60-120", "e 0.671", "p 99.8 kPa", "strain 11.4 %",
          "2.3e+07", "the hint"}) {
        EXPECT_NE(text.find(part == "60-120" ? "1.0-2 min" : part), std::string::npos) << part << " in\n" << text;
    }
}

TEST(Terminal, WithoutUtf8EverythingIsAscii) {
    for (const std::string& line : progress_lines(somewhere(), {60, 120}, "hint", 80, false)) {
        EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= 0x20 && c < 0x7f; })) << line;
    }
}

TEST(Terminal, WhatIsNoNumberIsNotShown) {
    EXPECT_EQ(state_text({{"void_ratio", nullptr}, {"mean_stress", "high"}}), "");
    EXPECT_EQ(state_text(nlohmann::json()), "");
}

TEST(Terminal, RedrawsAtMostTenTimesASecondAndCleansUp) {
    Written seen(true);
    for (int k = 0; k < 1000; ++k) { // within a few milliseconds
        seen.view.show(somewhere());
    }
    EXPECT_LE(seen.lines(), 3 * 6);
    EXPECT_GE(seen.lines(), 3);
    seen.view.clear();
    EXPECT_NE(seen.text.find("\x1b[J"), std::string::npos);
}

TEST(Terminal, APipeGetsOneLineAtAStagesEndWithoutControlCharacters) {
    Written seen(false);
    for (int k = 0; k < 100; ++k) {
        seen.view.show(somewhere());
    }
    EXPECT_EQ(seen.lines(), 0);
    run::Progress end = somewhere();
    end.stage_finished = true;
    seen.view.show(end);
    EXPECT_EQ(seen.lines(), 1);
    EXPECT_EQ(seen.text.find('\x1b'), std::string::npos);
    EXPECT_NE(seen.text.find("2/3 fines-sweep/fc=20/rep=1/shear done in 1 min 0 s"), std::string::npos) << seen.text;
}

TEST(Terminal, QuietSaysNothing) {
    Written seen(true, true);
    run::Progress end = somewhere();
    end.stage_finished = true;
    seen.view.show(end);
    seen.view.clear();
    EXPECT_EQ(seen.text, "");
}

TEST(TimeLeft, IsThePlanAtTheStartAndNothingAtTheEnd) {
    TimeLeft left(three_stages());
    run::Progress progress;
    progress.stage_number = 1;
    progress.stages = 3;
    EXPECT_DOUBLE_EQ(left.left(progress).least, 300);
    EXPECT_DOUBLE_EQ(left.left(progress).most, 600);
    progress.stage_number = 3;
    progress.stage_finished = true;
    EXPECT_DOUBLE_EQ(left.left(progress).most, 0);
}

TEST(TimeLeft, LearnsThatTheMachineIsSlowerThanPlanned) {
    TimeLeft left(three_stages());
    run::Progress first;
    first.stage_number = 1;
    first.stages = 3;
    first.stage_finished = true;
    first.stage_seconds = 2 * std::sqrt(100.0 * 200.0); // twice the middle of its range
    left.learn(first);
    // Two stages are left, at nearly twice their price: the plan still weighs as much as five seconds of experience.
    EXPECT_NEAR(left.left(first).least, 2 * 200, 0.05 * 400);
    EXPECT_NEAR(left.left(first).most, 2 * 400, 0.05 * 800);
}

TEST(TimeLeft, AStageBeyondItsRangeStillTakesTime) {
    const TimeLeft left(three_stages());
    run::Progress late;
    late.stage_number = 3;
    late.stages = 3;
    late.stage_seconds = 300; // of 100 to 200
    EXPECT_DOUBLE_EQ(left.left(late).least, 0);
    EXPECT_DOUBLE_EQ(left.left(late).most, 150);
}

} // namespace
} // namespace suffuse::apps
