// The samples of a sweep: the same bits one after the other and side by side, across a stop, and when one of them
// fails.

#include "suffuse/base/constants.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/io/checkpoint.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>
#include <map>
#include <set>

namespace suffuse::test {
namespace {

// Nearly of one size: a few hundred grains are a sample.
const std::string soil = R"(
[soil.sand]
psd = { d = ["0.25 mm", "0.3 mm", "0.35 mm"], passing = ["0 %", "50 %", "100 %"] }
)";

const std::string study = R"(
[study.s]
soil       = "sand"
particles  = 250
sweep      = { "stage.sheared.stress_ratio" = [0.2, 0.3] }
replicates = 2
)" + cloud_and_initial + R"(
[[study.s.stage]]
name         = "sheared"
do           = "triaxial"
stress_ratio = 0.2
strain       = "2 %"
)";

const std::string usual_sweep = R"("stage.sheared.stress_ratio" = [0.2, 0.3])";

std::string sweep_case(const std::string& sweep = usual_sweep) {
    std::string text = reference_constants + soil + study;
    return text.replace(text.find(usual_sweep), usual_sweep.size(), sweep);
}

/// Hash of every stage that the run folder holds, by its place.
std::map<std::string, std::string> hashes(const TempFolder& folder) {
    std::map<std::string, std::string> found;
    const std::filesystem::path studies = folder / "run/studies";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(studies)) {
        if (entry.path().filename() == "stage.json") {
            const std::string place = std::filesystem::relative(entry.path().parent_path(), studies);
            found[place] = record::read_json(entry.path()).at("state_hash");
        }
    }
    return found;
}

class Sweep : public testing::Test {
protected:
    void TearDown() override { set_thread_count(1); }
};

TEST_F(Sweep, SamplesSideBySideEndWithTheBitsOfOneAfterTheOther) {
    const TempFolder alone;
    run_text(sweep_case(), alone.path());
    const auto expected = hashes(alone);
    ASSERT_EQ(expected.size(), 2U * 2 * 3);
    for (const int threads : {2, 3, 8}) { // 8: two threads a sample
        set_thread_count(threads);
        const TempFolder folder;
        std::map<int, int> stages_of_sample;
        run::RunOptions options;
        options.on_progress = [&](const run::Progress& progress) {
            stages_of_sample[progress.sample] += progress.stage_finished ? 1 : 0;
        };
        run_text(sweep_case(), folder.path(), options);
        EXPECT_EQ(hashes(folder), expected) << threads << " threads";
        EXPECT_EQ(stages_of_sample, (std::map<int, int>{{1, 3}, {2, 3}, {3, 3}, {4, 3}}));
    }
}

TEST_F(Sweep, ACopyWithASweptContactKeyHasTheBitsOfACaseWithThatValue) {
    const TempFolder swept, single;
    run_text(sweep_case(R"("contact.friction" = ["20 deg", "37 deg"])"), swept.path());
    std::string text = sweep_case();
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"\"37 deg\"", "\"20 deg\""},
          {"sweep      = { " + usual_sweep + " }\n", ""}}) {
        text.replace(text.find(from), from.size(), to);
    }
    run_text(text, single.path());
    const auto of_swept = hashes(swept), of_single = hashes(single);
    for (const std::string stage : {"cloud", "initial", "sheared"}) {
        const std::string end = "/rep=1/" + stage;
        EXPECT_EQ(of_swept.at("s/friction=20deg" + end), of_single.at("s" + end)) << stage;
    }
    EXPECT_NE(of_swept.at("s/friction=20deg/rep=1/initial"), of_swept.at("s/friction=37deg/rep=1/initial"));
    EXPECT_EQ(
        io::load_world(swept / "run/studies/s/friction=20deg/rep=1/sheared/state.h5").world.material.friction,
        radians(20)
    );
}

TEST_F(Sweep, AStopSavesEverySampleAndTheRunGoesOnToTheSameBits) {
    // A last stage of so many bursts that none of two samples can end it before the other has begun.
    const std::string long_case = sweep_case() + R"([[study.s.stage]]
name        = "moved"
do          = "advance"
steps       = 30_000
strain_rate = ["1 1/s", "0 1/s", "0 1/s"]
)";
    const TempFolder straight, broken;
    run_text(long_case, straight.path());
    set_thread_count(2);
    std::size_t most_partial = 0;
    int stops = 0;
    for (int pulses = 20;; pulses *= 2) {
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int left = pulses;
        std::set<int> midway; // samples between two ends of stages
        options.on_progress = [&](const run::Progress& progress) {
            if (progress.stage_finished || progress.sample_ended) {
                midway.erase(progress.sample);
            } else if (progress.steps > 0) {
                midway.insert(progress.sample);
            }
            stop = stop || (--left <= 0 && midway.size() == 2);
        };
        if (run_text(long_case, broken.path(), options).outcome != record::Outcome::Stopped) {
            break;
        }
        std::size_t partial = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(broken / "run/studies")) {
            partial += entry.path().filename() == "partial.h5" ? 1U : 0U;
        }
        most_partial = std::max(most_partial, partial);
        ASSERT_LT(++stops, 100);
    }
    EXPECT_GE(stops, 1);
    EXPECT_EQ(most_partial, 2U) << "both samples were taken up where they stood";
    EXPECT_EQ(hashes(broken), hashes(straight));
}

TEST_F(Sweep, AFailedSampleIsReportedAndDoesNotStopTheOthers) {
    set_thread_count(2);
    const TempFolder folder;
    int failures_seen = 0;
    run::RunOptions options;
    options.on_progress = [&](const run::Progress& progress) { failures_seen += progress.failure.empty() ? 0 : 1; };
    // A strain of a millionth is no way to a deviator stress.
    const std::string sweep = R"("stage.sheared.strain" = ["2 %", "0.0001 %"])";
    const job::RunReport report = run_text(sweep_case(sweep), folder.path(), options);
    EXPECT_EQ(report.outcome, record::Outcome::SomeFailed);
    ASSERT_EQ(report.failures.size(), 2U); // both seeds
    EXPECT_EQ(report.failures[0].sample, "s/strain=0.0001pct/rep=1");
    EXPECT_EQ(report.failures[0].stage, "sheared");
    EXPECT_NE(report.failures[0].message.find("cannot reach the specified stress"), std::string::npos);
    EXPECT_EQ(failures_seen, 2);
    const nlohmann::json summary = record::read_json(folder / "run/summary.json");
    EXPECT_EQ(summary.at("samples"), (nlohmann::json{{"total", 4}, {"done", 2}, {"failed", 2}}));
    EXPECT_EQ(summary.at("failures").at(1).at("sample"), "s/strain=0.0001pct/rep=2");
    EXPECT_TRUE(summary.at("stages").contains("s/strain=2pct/rep=2/sheared"));
    EXPECT_TRUE(std::filesystem::exists(folder / "run/report.html"));
    // Tried again, it says so again, and what is done is not done again.
    EXPECT_EQ(run_text(sweep_case(sweep), folder.path()).failures.size(), 2U);
}

TEST_F(Sweep, EachSampleEndsWithTheRequestedLastStage) {
    set_thread_count(2);
    const TempFolder folder;
    run::RunOptions options;
    options.until = "initial";
    EXPECT_EQ(run_text(sweep_case(), folder.path(), options).outcome, record::Outcome::Done);
    EXPECT_EQ(hashes(folder).size(), 2U * 2 * 2);
}

/// How many stages of a run were taken from the cache.
int count_cached(const TempFolder& folder, const std::string& text, const std::filesystem::path& cache) {
    int cached = 0;
    run::RunOptions options;
    options.cache = cache;
    options.on_progress = [&](const run::Progress& progress) { cached += progress.from_cache ? 1 : 0; };
    run_text(text, folder.path(), options);
    return cached;
}

TEST_F(Sweep, WhatOneRunComputedTheNextOneTakesFromTheCache) {
    set_thread_count(2);
    const TempFolder shared, first, again, changed, plain;
    const std::filesystem::path cache = shared / "cache";
    // Two values of the last stage: clouds and compactions are those of the first value, unless both began at once.
    const int within = count_cached(first, sweep_case(), cache);
    EXPECT_LE(within, 2 * 2);
    EXPECT_EQ(count_cached(again, sweep_case(), cache), 2 * 2 * 3);
    EXPECT_EQ(hashes(again), hashes(first));
    std::string text = sweep_case();
    text.replace(text.find("pressure = \"100 kPa\""), 20, "pressure =  \"90 kPa\"");
    const int as_before = count_cached(changed, text, cache);
    EXPECT_GE(as_before, 2 * 2) << "the clouds";
    EXPECT_LE(as_before, 2 * 2 + 2) << "the clouds, and what the first value of this run has computed for the second";
    run_text(text, plain.path());
    EXPECT_EQ(hashes(changed), hashes(plain));
    // Names are of the run that takes, not of the one that made.
    const nlohmann::json taken = stage_of(again.path(), "stress_ratio=0.2/rep=1/cloud");
    EXPECT_EQ(taken.at("stage"), "cloud");
    EXPECT_TRUE(taken.at("from_cache"));
}

} // namespace
} // namespace suffuse::test
