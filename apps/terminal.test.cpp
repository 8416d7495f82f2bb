#include "apps/terminal.hpp"

#include "suffuse/plan/sum_ranges.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/wording.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>

namespace suffuse::apps {
namespace {

run::Progress somewhere() {
    run::Progress progress;
    progress.study = "fines-sweep/fc=20/rep=1";
    progress.stage = "shear";
    progress.verb = "triaxial";
    progress.sample = 1;
    progress.samples = 1;
    progress.stage_number = 2;
    progress.stages = 3;
    progress.stages_done = 1;
    progress.part = "shear";
    progress.steps = 12'345;
    progress.stage_seconds = 60;
    progress.particle_steps_per_second = 2.31e7;
    progress.state = {{"void_ratio", 0.6713}, {"mean_stress", 99.8e3}, {"axial_strain", 0.114}, {"odd", "text"}};
    return progress;
}

/// So many samples at the same place.
Running several(int samples) {
    Running running;
    for (int k = 1; k <= samples; ++k) {
        running[k] = somewhere();
        running[k].sample = k;
        running[k].study = fmt::format("fines-sweep/fc={}", k);
    }
    return running;
}

/// Three stages, 100 to 200 s each.
plan::RunPlan three_stages() {
    plan::RunPlan plan;
    plan.stages.resize(3);
    for (plan::StageEstimate& stage : plan.stages) {
        stage.study = "one";
        stage.steps = {1000, 2000};
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
        for (const int samples : {1, 2, 64}) {
            const auto lines = progress_lines(
                somewhere(), several(samples), {60, 120}, "Ctrl-C saves; suffuse resume runs/x-0001", width, true
            );
            EXPECT_GE(lines.size(), 3U);
            EXPECT_LE(lines.size(), 7U);
            for (const std::string& line : lines) {
                EXPECT_LE(columns_of(line), width) << line;
            }
        }
    }
}

TEST(Terminal, ANumberIsShownWholeOrNotAtAll) {
    run::Progress progress = somewhere();
    progress.state["unbalanced_force"] = 1.4e-9; // not 1
    const std::string whole = progress_lines(progress, {{1, progress}}, {60, 120}, "hint", 200, true).at(2);
    for (std::size_t width = 20; width < 100; ++width) {
        const std::string line = progress_lines(progress, {{1, progress}}, {60, 120}, "hint", width, true).at(2);
        ASSERT_TRUE(whole.starts_with(line)) << line;
        EXPECT_TRUE(line.size() == whole.size() || whole.compare(line.size(), 2, "  ") == 0) << line;
    }
}

TEST(Terminal, AWideOneShowsEverythingThatMatters) {
    std::string text;
    for (const std::string& line : progress_lines(somewhere(), {{1, somewhere()}}, {60, 120}, "the hint", 200, true)) {
        text += line + "\n";
    }
    for (const std::string part :
         {"fines-sweep/fc=20/rep=1/shear", "12,345", "1/3", "60-120", "e 0.671", "p 99.8 kPa", "strain 11.4 %",
          "2.3e+07", "the hint"}) {
        EXPECT_NE(text.find(part == "60-120" ? "1.0-2 min" : part), std::string::npos) << part << " in\n" << text;
    }
}

TEST(Terminal, WithoutUtf8EverythingIsAscii) {
    for (const std::string& line : progress_lines(somewhere(), several(3), {60, 120}, "hint", 80, false)) {
        EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c >= 0x20 && c < 0x7f; })) << line;
    }
}

TEST(Terminal, WhatIsNoNumberIsNotShown) {
    EXPECT_EQ(state_text({{"void_ratio", nullptr}, {"mean_stress", "high"}}), "");
    EXPECT_EQ(state_text(nlohmann::json()), "");
    const nlohmann::json passes = {
        {{"eroded_mass_percent_of_initial", 20.0}}, {{"eroded_mass_percent_of_initial", 0.4}}};
    EXPECT_EQ(state_text({{"passes", passes}, {"void_ratio", 0.9}}), "eroded 20.4 % of the mass  e 0.9");
    EXPECT_EQ(state_text({{"passes", passes}, {"verb", "remove"}}), "removed 20.4 % of the mass");
}

TEST(Terminal, RedrawsAtMostTenTimesASecondAndCleansUp) {
    const auto start = std::chrono::steady_clock::now();
    Written seen(true);
    seen.view.show(somewhere());
    const std::ptrdiff_t lines = seen.lines();
    EXPECT_GE(lines, 3);
    for (int k = 0; k < 1000; ++k) {
        seen.view.show(somewhere());
    }
    const auto tenths = (std::chrono::steady_clock::now() - start) / std::chrono::milliseconds(100);
    EXPECT_LE(seen.lines(), lines * (1 + tenths)); // none, unless somebody holds us up
    seen.view.clear();
    EXPECT_NE(seen.text.find("\x1b[J"), std::string::npos);
}

TEST(Terminal, APipeGetsOneLineAtAStagesEndWithoutControlCharacters) {
    const auto start = std::chrono::steady_clock::now();
    Written seen(false);
    for (int k = 0; k < 100; ++k) {
        seen.view.show(somewhere());
    }
    const std::ptrdiff_t before = seen.lines();
    EXPECT_LE(before, (std::chrono::steady_clock::now() - start) / std::chrono::seconds(30));
    run::Progress end = somewhere();
    end.stage_finished = true;
    end.stages_done = 2;
    seen.view.show(end);
    EXPECT_EQ(seen.lines(), before + 1);
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

TEST(Terminal, ShowsALineForEachSampleThatRunsAndOneForTheRest) {
    run::Progress latest = somewhere();
    latest.samples = 26;
    latest.samples_done = 5;
    latest.samples_failed = 1;
    std::string text;
    for (const std::string& line : progress_lines(latest, several(6), {60, 120}, "hint", 200, true)) {
        text += line + "\n";
    }
    for (const std::string part :
         {"samples 5/26, 1 FAILED", "fines-sweep/fc=1/shear: shear, step 12,345  e 0.671", "fines-sweep/fc=4/shear",
          "and 2 more"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
    }
    EXPECT_EQ(text.find("fc=5"), std::string::npos);
}

TEST(Terminal, AFailureIsReportedAtOnceAndStaysOnTheScreen) {
    for (const bool redraws : {true, false}) {
        Written seen(redraws);
        seen.view.show(somewhere());
        run::Progress failed = somewhere();
        failed.sample_ended = true;
        failed.failure = "the stress is out of reach";
        seen.view.show(failed);
        seen.view.clear();
        const std::size_t at = seen.text.find("rep=1/shear FAILED: the stress is out of reach\n");
        ASSERT_NE(at, std::string::npos) << seen.text;
        EXPECT_EQ(seen.text.find("\x1b[5A", at), std::string::npos) << "drawn over";
    }
}

/// A stage of the first plan, or its end.
run::Progress at_stage(int number, double seconds, bool is_finished) {
    run::Progress progress;
    progress.study = "one";
    progress.sample = progress.samples = 1;
    progress.stage_number = number;
    progress.stages = 3;
    progress.stage_seconds = seconds;
    progress.stage_finished = is_finished;
    return progress;
}

TEST(Terminal, ANarrowTerminalGetsWholeWords) {
    const auto lines = [](std::size_t width) {
        std::string text;
        for (const std::string& line : progress_lines(
                 somewhere(), {{1, somewhere()}}, {60, 120}, "Ctrl-C saves; suffuse resume runs/dyke-0001", width, true
             )) {
            text += line + "\n";
        }
        return text;
    };
    EXPECT_NE(lines(120).find("Ctrl-C saves; suffuse resume runs/dyke-0001\n"), std::string::npos);
    EXPECT_NE(lines(120).find("grain-steps/s\n"), std::string::npos);
    EXPECT_NE(lines(50).find("Ctrl-C saves\n"), std::string::npos); // the rest of the hint comes with Ctrl-C
    EXPECT_EQ(lines(50).find("grain-"), std::string::npos);
}

/// So many stages of 100 to 200 seconds together.
Range stages_of_100_to_200(std::size_t count) {
    return plan::sum_ranges(std::vector<Range>(count, {100, 200}));
}

TEST(TimeLeft, IsThePlanAtTheStartAndNothingAtTheEnd) {
    TimeLeft left(three_stages());
    EXPECT_DOUBLE_EQ(left.left().least, stages_of_100_to_200(3).least);
    EXPECT_DOUBLE_EQ(left.left().most, stages_of_100_to_200(3).most);
    for (const int number : {1, 2, 3}) {
        left.see(at_stage(number, 100, true));
    }
    EXPECT_DOUBLE_EQ(left.left().most, 0);
}

TEST(TimeLeft, LearnsThatTheMachineIsSlowerThanPlanned) {
    TimeLeft left(three_stages());
    left.see(at_stage(1, 2 * std::sqrt(100.0 * 200.0), true)); // twice the middle of its range
    // Two stages are left, at nearly twice their price: the plan still weighs as much as five seconds of experience.
    const Range two = stages_of_100_to_200(2);
    EXPECT_NEAR(left.left().least, 2 * two.least, 0.05 * 400);
    EXPECT_NEAR(left.left().most, 2 * two.most, 0.05 * 800);
}

TEST(TimeLeft, DoesNotLearnTheSpeedOfStepsFromAStageThatMakesNone) {
    plan::RunPlan plan = three_stages();
    plan.stages[0].steps = {}; // a cloud
    TimeLeft left(plan);
    left.see(at_stage(1, 10'000, true));
    EXPECT_DOUBLE_EQ(left.left().most, stages_of_100_to_200(2).most);
}

TEST(TimeLeft, UsesThePaceOfTheRunningStageAsLongAsNoneIsDone) {
    plan::RunPlan plan = three_stages();
    for (plan::StageEstimate& stage : plan.stages) {
        stage.grains = 1000;
        stage.steps = {1000, 2000}; // priced at 10,000 grain-steps a second
    }
    TimeLeft left(plan);
    run::Progress slow = at_stage(1, 10, false);
    slow.particle_steps_per_second = 5000;
    left.see(slow);
    EXPECT_NEAR(left.left().least, plan::sum_ranges({{190, 390}, {200, 400}, {200, 400}}).least, 1e-9);
    slow.stage_seconds = 1; // too early to tell
    TimeLeft early(plan);
    early.see(slow);
    EXPECT_NEAR(early.left().least, plan::sum_ranges({{99, 199}, {100, 200}, {100, 200}}).least, 1e-9);
}

TEST(TimeLeft, AStageBeyondItsRangeStillTakesTime) {
    plan::RunPlan last = three_stages();
    last.stages[0].seconds = last.stages[1].seconds = {};
    TimeLeft left(last);
    left.see(at_stage(3, 300, false)); // of 100 to 200
    EXPECT_DOUBLE_EQ(left.left().least, 0);
    EXPECT_DOUBLE_EQ(left.left().most, 150);
}

TEST(TimeLeft, IsSharedAmongSamplesButNoLessThanTheLongest) {
    plan::RunPlan plan = three_stages();
    plan.speed.at_once = 2;
    plan.stages[2].study = "two";
    const Range two = stages_of_100_to_200(2), three = stages_of_100_to_200(3);
    EXPECT_DOUBLE_EQ(TimeLeft(plan).left().most, two.most); // the two stages of "one"; "two" runs next to them
    plan.stages[1].study = "three";
    EXPECT_DOUBLE_EQ(TimeLeft(plan).left().most, three.most / 2); // three samples in two rows, if they could be cut
    TimeLeft left(plan);
    run::Progress failed = at_stage(1, 10, false);
    failed.sample_ended = true;
    failed.failure = "why";
    left.see(failed);
    EXPECT_DOUBLE_EQ(left.left().most, std::max(two.most / 2, 200.0)); // what it left undone will not be done
}

TEST(TimeLeft, CountsTheSamplesThatRefineWillAdd) {
    plan::RunPlan plan = three_stages();
    plan.refined = {{1, 4}, {30, 50}};
    TimeLeft left(plan);
    EXPECT_DOUBLE_EQ(left.left().least, stages_of_100_to_200(3).least + 30);
    EXPECT_DOUBLE_EQ(left.left().most, stages_of_100_to_200(3).most + 4 * 50);
    for (const int number : {1, 2, 3}) {
        left.see(at_stage(number, middle({100, 200}), true));
    }
    run::Progress added = at_stage(2, 1, false); // numbered as if it stood among the listed ones
    added.study = "one/fc=32.5";
    added.samples = 3; // two more than before
    left.see(added);
    EXPECT_NEAR(left.left().least, 2 * 30, 1e-9);
    EXPECT_NEAR(left.left().most, 2 * 50, 1e-9);
    added.sample_ended = true;
    left.see(added);
    EXPECT_NEAR(left.left().most, 50, 1e-9);
}

} // namespace
} // namespace suffuse::apps
