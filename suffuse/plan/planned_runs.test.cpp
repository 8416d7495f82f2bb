#include "suffuse/casefile/load_case.hpp"
#include "suffuse/plan/plan.hpp"
#include "suffuse/plan/plan_record.hpp"
#include "suffuse/plan/sum_ranges.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace suffuse::plan {
namespace {

/// A stage of a recorded run: its case as on the command line, the machine's speed then, what the stage took.
struct Recorded {
    std::string use, what, preset, overrides, threads, at_once, speed, reference_speed, stage;
    double steps = 0, seconds = 0;
};

std::vector<Recorded> read_recorded(const std::string& file) {
    std::ifstream in(file);
    std::vector<Recorded> rows;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#' || line.starts_with("use,")) {
            continue;
        }
        std::istringstream cells(line);
        Recorded row;
        std::string steps, seconds;
        for (std::string* cell :
             {&row.use, &row.what, &row.preset, &row.overrides, &row.threads, &row.at_once, &row.speed,
              &row.reference_speed, &row.stage, &steps, &seconds}) {
            std::getline(cells, *cell, ',');
        }
        row.steps = std::stod(steps), row.seconds = std::stod(seconds);
        rows.push_back(row);
    }
    return rows;
}

/// Tests lent no inertia before rows of the use "lent" were recorded.
void lend_nothing(casefile::Case& what) {
    for (casefile::Study& study : what.studies) {
        for (casefile::Variant& variant : study.variants) {
            for (casefile::Stage& stage : variant.stages) {
                if (auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.spec)) {
                    spec->inertia = triaxial::GrainInertia::Own;
                }
            }
        }
    }
}

RunPlan plan_of(const Recorded& row) {
    std::vector<std::string> overrides;
    std::string text = row.overrides;
    std::replace(text.begin(), text.end(), '|', ','); // the table's own columns end at commas
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ';');) {
        overrides.push_back(word);
    }
    casefile::Case what = casefile::load_case(test::in_checkout(row.what), {row.preset, overrides}).value;
    if (row.use != "lent") {
        lend_nothing(what);
    }
    MachineSpeed speed{std::stod(row.speed), 10'000, std::stoi(row.threads), std::stoi(row.at_once)};
    speed.in_reference_mode = std::stod(row.reference_speed);
    return plan_run(what, speed);
}

struct RecordedRun {
    std::vector<Range> planned_seconds; ///< of its stages
    double seconds = 0;                 ///< that they took
};

struct Judged {
    std::vector<StageOutcome> stages;
    std::map<std::string, RecordedRun> runs;
    int inside = 0; ///< stages whose seconds lie within their range
};

Judged judge(const std::string& use) {
    std::map<std::string, RunPlan> plans;
    Judged judged;
    for (const Recorded& row : read_recorded(test::in_checkout("tests/reference/planned_runs.csv"))) {
        if (row.use != use) {
            continue;
        }
        const std::string key = fmt::format("{} {} {}", row.what, row.preset, row.overrides);
        if (!plans.contains(key)) {
            plans[key] = plan_of(row);
        }
        for (const StageEstimate& stage : plans.at(key).stages) {
            if (stage.study + "/" + stage.stage != row.stage) {
                continue;
            }
            judged.stages.push_back({stage.steps, stage.seconds, row.steps, row.seconds});
            RecordedRun& run = judged.runs[key];
            run.planned_seconds.push_back(stage.seconds), run.seconds += row.seconds;
            judged.inside += row.seconds >= stage.seconds.least && row.seconds <= stage.seconds.most ? 1 : 0;
        }
    }
    return judged;
}

TEST(Plan, RecordedRunsTookWhatItSaysWithinAQuarterInTheMedian) {
    // Runs by which the planner's constants were set, and runs that it had not seen.
    for (const std::string use : {"fitted", "held"}) {
        const Judged judged = judge(use);
        ASSERT_GE(judged.stages.size(), 20U) << use;
        const auto error = measure_plan_error(judged.stages);
        ASSERT_TRUE(error);
        EXPECT_LT(error->of_steps, 0.25) << use;
        EXPECT_LT(error->of_seconds, 0.25) << use;
        std::vector<StageOutcome> runs;
        std::ptrdiff_t inside = 0;
        for (const auto& [key, run] : judged.runs) {
            const Range planned = sum_ranges(run.planned_seconds);
            runs.push_back({{}, planned, 0, run.seconds});
            inside += planned.least <= run.seconds && run.seconds <= planned.most ? 1 : 0;
        }
        EXPECT_EQ(inside, std::ssize(runs)) << use;
        EXPECT_LT(measure_plan_error(runs)->of_seconds, 0.25) << use;
        EXPECT_GT(judged.inside, 0.8 * static_cast<double>(judged.stages.size())) << use;
    }
}

TEST(Plan, RecordedTestsWithLentInertiaTookTheStepsThatItSaysWithinAQuarterInTheMedian) {
    const Judged judged = judge("lent"); // their seconds are of a busy machine
    ASSERT_GE(judged.stages.size(), 10U);
    const auto error = measure_plan_error(judged.stages);
    ASSERT_TRUE(error);
    EXPECT_LT(error->of_steps, 0.25);
}

} // namespace
} // namespace suffuse::plan
