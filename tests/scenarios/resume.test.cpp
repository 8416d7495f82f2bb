// A run that is stopped half-way and resumed ends with the same bits as one that is not.

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/stage_sums.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>
#include <cmath>
#include <map>
#include <utility>

namespace suffuse::test {
namespace {

/// A cloud of the reference's sand, brought to 100 kPa.
std::string sample_of(int particles) {
    return reference_constants + reference_soil() +
           fmt::format("[study.s]\nsoil = \"sand\"\nparticles = {}\n", particles) + cloud_and_initial;
}

const std::string later_stages = R"(
[[study.s.stage]]
name         = "sheared"
do           = "triaxial"
stress_ratio = 0.5
strain       = "5 %"
[[study.s.stage]]
name       = "probed"
do         = "stress-probe"
directions = 4
[[study.s.stage]]
name        = "moved"
do          = "advance"
steps       = 700
strain_rate = ["1 1/s", "0 1/s", "0 1/s"]
)";

const std::string erosion_of_two_passes = R"(
[[study.s.stage]]
name     = "erosion"
do       = "erode"
passes   = 2
gradient = 0.05
)";

std::string whole_case() {
    return sample_of(600) + later_stages + erosion_of_two_passes;
}

std::string hash_of(const TempFolder& folder, const std::string& stage) {
    return stage_of(folder.path(), stage).at("state_hash");
}

const std::vector<std::string> names{"cloud", "initial", "sheared", "probed", "moved", "erosion"};

TEST(Resume, AfterStopsInTheMiddleOfStagesTheBitsAreTheSame) {
    const TempFolder straight, broken;
    run_text(whole_case(), straight.path());

    // Stops at ever later pulses, so that every verb is interrupted somewhere.
    int stops = 0;
    for (int pulses = 5;; pulses = pulses * 3 / 2) {
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        int left = pulses;
        options.progress_interval = 0;
        options.on_progress = [&](const run::Progress&) {
            if (--left <= 0) {
                stop = true;
            }
        };
        const job::RunReport report = run_text(whole_case(), broken.path(), options);
        if (report.outcome != record::Outcome::Stopped) {
            break;
        }
        ++stops;
        ASSERT_LT(stops, 200);
    }
    EXPECT_GE(stops, 2);
    for (const std::string& stage : names) {
        EXPECT_EQ(hash_of(broken, stage), hash_of(straight, stage)) << stage;
    }
    EXPECT_EQ(
        stage_of(broken.path(), "probed").at("stress_probes"), stage_of(straight.path(), "probed").at("stress_probes")
    );
    EXPECT_EQ(
        stage_of(broken.path(), "erosion").at("passes").at(0).at("permeability_after"),
        stage_of(straight.path(), "erosion").at("passes").at(0).at("permeability_after")
    );
}

const std::string passes_of_short_probes = R"(
[[study.s.stage]]
name     = "erosion"
do       = "erode"
passes   = 2
gradient = 0.05
ramp     = 50
watch    = 50
probe_unbalanced_force = 1e-12
[[study.s.stage]]
name   = "emptied"
do     = "remove"
grains = "fines"
share  = "30 %"
passes = 2
)";

TEST(Resume, WithinAPassGoesOnFromTheLastBurst) {
    const TempFolder straight, broken;
    const std::string text = sample_of(600) + passes_of_short_probes;
    run_text(text, straight.path());
    std::map<std::string, int> stops;
    for (bool is_over = false; !is_over;) {
        std::atomic<bool> stop{false};
        std::string stopped_in;
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int beats = 0;
        options.on_progress = [&](const run::Progress& progress) {
            const bool is_removal = progress.stage == "emptied"; // it takes some 30,000 steps a pass
            beats += progress.stage == "erosion" || is_removal ? 1 : 0;
            if (beats >= (is_removal ? 100 : 6) && !stop) { // less than a pass, and more than a probe
                stop = true;
                stopped_in = progress.stage + ", " + progress.part;
            }
        };
        is_over = run_text(text, broken.path(), options).outcome != record::Outcome::Stopped;
        ++stops[stopped_in];
        ASSERT_LT(stops[stopped_in], 100) << stopped_in;
    }
    for (const char* part : {"erosion, relax", "erosion, servo", "emptied, servo"}) {
        EXPECT_GE(stops[part], 2) << part;
    }
    for (const char* stage : {"erosion", "emptied"}) {
        EXPECT_EQ(hash_of(broken, stage), hash_of(straight, stage)) << stage;
        const auto passes = [&](const TempFolder& folder) {
            nlohmann::json all = stage_of(folder.path(), stage).at("passes");
            for (nlohmann::json& pass : all) {
                pass.erase("wall_seconds");
            }
            return all;
        };
        EXPECT_EQ(passes(broken), passes(straight));
    }
    const auto path = [](const TempFolder& folder) {
        return record::read_cbor(folder / "run/studies/s/erosion/results.cbor").at("erosion").at("path");
    };
    EXPECT_EQ(path(broken), path(straight));
}

/// Fines so small that most float: without water the median one of them does not move at all.
const std::string floating_fines = R"(
[soil.mixture]
coarse            = { psd = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] } }
fines             = { psd = { d = ["0.056 mm", "0.064 mm"], passing = ["0 %", "100 %"] } }
fines_content     = "8 %"
grading_tolerance = "10 %"
[study.s]
soil      = "mixture"
particles = 1500
[[study.s.stage]]
name = "cloud"
do   = "pack"
[[study.s.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
protocol = "swift"
[[study.s.stage]]
name     = "erosion"
do       = "erode"
passes   = 3
gradient = 0.05
)";

TEST(Resume, OfAnErosionKeepsWhatIsInfinite) {
    const TempFolder straight, broken;
    const std::string text = reference_constants + floating_fines;
    run_text(text, straight.path());
    std::atomic<bool> stop{false};
    run::RunOptions options;
    options.stop = &stop;
    options.progress_interval = 0;
    options.on_progress = [&](const run::Progress&) {
        stop = std::filesystem::exists(broken / "run/studies/s/erosion/partial.h5");
    };
    ASSERT_EQ(run_text(text, broken.path(), options).outcome, record::Outcome::Stopped);
    const job::RunReport report = run_text(text, broken.path());
    ASSERT_TRUE(report.failures.empty()) << report.failures.front().message;
    EXPECT_EQ(hash_of(broken, "erosion"), hash_of(straight, "erosion"));
    const auto signal_of_first_pass = [](const TempFolder& folder) {
        const nlohmann::json results = record::read_cbor(folder / "run/studies/s/erosion/results.cbor");
        return results.at("erosion").at("passes").at(0).at("probe").at("signal_over_twin").get<double>();
    };
    EXPECT_TRUE(std::isinf(signal_of_first_pass(straight))); // what the test is about
    EXPECT_TRUE(std::isinf(signal_of_first_pass(broken)));
}

TEST(Resume, AStateOfAnotherVersionWithinAStageIsRefusedOrLabeled) {
    const TempFolder folder;
    const std::string text = sample_of(300);
    const std::filesystem::path partial = folder / "run/studies/s/initial/partial.h5";
    std::atomic<bool> stop{false};
    run::RunOptions options;
    options.stop = &stop;
    options.progress_interval = 0;
    options.on_progress = [&](const run::Progress& progress) {
        stop = progress.stage == "initial" && progress.steps > 0;
    };
    ASSERT_EQ(run_text(text, folder.path(), options).outcome, record::Outcome::Stopped);
    const io::Checkpoint left = io::load_world(partial);
    const nlohmann::json saved = nlohmann::json::from_cbor(left.unfinished);

    nlohmann::json without_history = saved, without_key = saved, with_other_state = saved, of_another = saved;
    without_history.erase("history");
    without_key["state"].erase("known_contacts"); // a default in its place would be a mixture that nobody knows of
    with_other_state["state"] = "burst 3";
    of_another["commit"] = "0123456789";
    for (const nlohmann::json& strange : {without_history, without_key, with_other_state, nlohmann::json(nullptr)}) {
        io::save_world(partial, left.world, {}, {}, nlohmann::json::to_cbor(strange));
        const job::RunReport report = run_text(text, folder.path());
        ASSERT_EQ(report.failures.size(), 1U) << strange.dump();
        EXPECT_EQ(report.failures[0].kind, "io");
        const std::string& message = report.failures[0].message;
        EXPECT_NE(message.find("remove " + partial.string() + " and resume"), std::string::npos) << message;
    }
    io::save_world(partial, left.world, {}, {}, nlohmann::json::to_cbor(of_another));
    EXPECT_TRUE(run_text(text, folder.path()).failures.empty());
    const std::string warnings = stage_of(folder.path(), "initial").at("warnings").dump();
    EXPECT_NE(warnings.find("s/initial: begun by commit 0123456789 "), std::string::npos) << warnings;
}

TEST(Resume, ATimeLimitOfZeroStopsAtOnceAndLeavesARunThatGoesOn) {
    const TempFolder folder;
    run::RunOptions options;
    options.time_limit = 0;
    EXPECT_EQ(run_text(whole_case(), folder.path(), options).outcome, record::Outcome::TimeLimit);
    EXPECT_NE(run_text(whole_case(), folder.path()).outcome, record::Outcome::TimeLimit);
}

TEST(Resume, AStageThatIsCompleteHasNotFailed) {
    const TempFolder folder;
    const std::string text = sample_of(300);
    ASSERT_EQ(run_text(text, folder.path()).outcome, record::Outcome::Done);
    const std::filesystem::path failed = folder / "run/studies/s/cloud/failed.json";
    record::write_json(failed, {{"sample", "s"}, {"stage", "cloud"}, {"kind", "io"}, {"message", "the disk is full"}});
    const job::RunReport report = run_text(text, folder.path());
    EXPECT_EQ(report.outcome, record::Outcome::Done);
    EXPECT_TRUE(report.failures.empty());
    EXPECT_FALSE(std::filesystem::exists(failed));
}

TEST(Resume, ALineThatTheLogCannotTakeFailsNoStage) {
    const TempFolder folder;
    const std::filesystem::path log = folder / "run/events.jsonl";
    run::RunOptions options;
    bool is_first = true;
    options.progress_interval = 0;
    options.on_progress = [&](const run::Progress&) {
        if (std::exchange(is_first, false)) {
            std::filesystem::rename(log, folder / "run/earlier.jsonl");
            std::filesystem::create_directory(log);
        } else if (std::filesystem::exists(folder / "run/studies/s/initial/stage.json")) {
            std::filesystem::remove(log);
        }
    };
    EXPECT_EQ(run_text(sample_of(300), folder.path(), options).outcome, record::Outcome::Done);
}

TEST(Resume, FromAStateThatIsNotTheRecordedOneIsRefusedWithItsFile) {
    const TempFolder folder;
    run::RunOptions options;
    options.until = "cloud";
    ASSERT_EQ(run_text(sample_of(300), folder.path(), options).outcome, record::Outcome::Done);
    const std::filesystem::path state = folder / "run/studies/s/cloud/state.h5";
    dem::World world = io::load_world(state).world;
    world.grains.id[3] = 77777;
    io::save_world(state, world);
    std::string message;
    try {
        run_text(sample_of(300), folder.path());
    } catch (const IoError& error) {
        message = error.what();
    }
    EXPECT_NE(message.find(state.string()), std::string::npos) << message;
    EXPECT_NE(message.find("remove " + state.parent_path().string()), std::string::npos) << message;

    // With checksums that fit it is still not the state that its stage shows.
    record::seal_stage(state.parent_path(), record::read_json(state.parent_path() / "stage.json"));
    std::filesystem::remove(folder / "run/SHA256SUMS");
    const job::RunReport report = run_text(sample_of(300), folder.path());
    ASSERT_EQ(report.failures.size(), 1U);
    EXPECT_EQ(report.failures[0].kind, "io");
    message = report.failures[0].message;
    EXPECT_NE(message.find(state.string()), std::string::npos) << message;
    EXPECT_NE(message.find("remove " + state.parent_path().string()), std::string::npos) << message;

    std::filesystem::remove_all(state.parent_path());
    EXPECT_EQ(run_text(sample_of(300), folder.path()).outcome, record::Outcome::Done);
}

TEST(Resume, InTheMiddleOfAStageIsRefusedFromAStateThatWasChanged) {
    const TempFolder folder;
    const std::filesystem::path partial = folder / "run/studies/s/initial/partial.h5";
    std::atomic<bool> stop{false};
    run::RunOptions options;
    options.stop = &stop;
    options.progress_interval = 0;
    options.on_progress = [&](const run::Progress& progress) {
        stop = progress.stage == "initial" && progress.steps > 0;
    };
    ASSERT_EQ(run_text(sample_of(300), folder.path(), options).outcome, record::Outcome::Stopped);
    io::Checkpoint left = io::load_world(partial);
    left.world.grains.mass[3] *= 2;
    io::save_world(partial, left.world, {}, {}, left.unfinished);
    const job::RunReport report = run_text(sample_of(300), folder.path());
    ASSERT_EQ(report.failures.size(), 1U);
    const std::string& message = report.failures[0].message;
    EXPECT_NE(message.find(partial.string() + ": is not the state that was saved"), std::string::npos) << message;
    EXPECT_NE(message.find("remove " + partial.string()), std::string::npos) << message;
}

TEST(Resume, AReportOfAStateWithStrangeGrainsNamesItsFile) {
    const TempFolder folder;
    ASSERT_EQ(run_text(sample_of(300) + erosion_of_two_passes, folder.path()).outcome, record::Outcome::Done);
    const std::filesystem::path state = folder / "run/studies/s/erosion/state.h5";
    dem::World world = io::load_world(state).world;
    world.grains.id[3] = 77777;
    io::save_world(state, world);
    record::seal_stage(
        state.parent_path(), record::read_json(state.parent_path() / "stage.json")
    ); // as if it had ended so
    std::filesystem::remove(folder / "run/SHA256SUMS");
    try {
        run_text(sample_of(300) + erosion_of_two_passes, folder.path());
        FAIL() << "was reported";
    } catch (const IoError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(state.string() + ": names the grain 77777"), std::string::npos) << message;
    }
}

TEST(Resume, AFolderOfAnotherCaseIsRefused) {
    const TempFolder folder;
    run::RunOptions options;
    options.time_limit = 0;
    run_text(whole_case(), folder.path(), options);
    std::string other = whole_case();
    other.replace(other.find("particles = 600"), 15, "particles = 601");
    EXPECT_THROW(run_text(other, folder.path()), CaseError);
}

TEST(OwnTimeStep, BeyondWhatTheSampleCanTakeIsRefused) {
    const TempFolder folder;
    std::string text = whole_case();
    text.replace(
        text.find("pressure = \"100 kPa\""), 0, "time_step = \"1 us\"\n"
    ); // of the compaction: ten times too long
    const job::RunReport report = run_text(text, folder.path());
    EXPECT_EQ(report.outcome, record::Outcome::SomeFailed);
    ASSERT_EQ(report.failures.size(), 1U);
    EXPECT_NE(report.failures[0].message.find("time_step: found 1000 ns, expected at most"), std::string::npos)
        << report.failures[0].message;
}

class Threads : public testing::Test {
protected:
    void TearDown() override { set_thread_count(1); }
};

TEST_F(Threads, ChangeNoBitOfAWholeRun) {
    std::vector<std::string> hashes;
    for (const int threads : {1, 2, 4}) {
        set_thread_count(threads);
        const TempFolder folder;
        run_text(whole_case(), folder.path());
        std::string all;
        for (const std::string& stage : names) {
            all += hash_of(folder, stage);
        }
        hashes.push_back(all);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
    EXPECT_EQ(hashes[0], hashes[2]);
}

} // namespace
} // namespace suffuse::test
