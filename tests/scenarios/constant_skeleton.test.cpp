// Samples of a study that keep their coarse skeleton: made first, or prepared as another sample; in any order, alone,
// and after a stop, to the same bits.

#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>

namespace suffuse::test {
namespace {

using nlohmann::json;

/// Fines that pass between three coarse grains that touch.
const std::string soil_of_small_fines = R"(
[soil.mixture]
coarse            = { psd = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] } }
fines             = { psd = { d = ["0.043 mm", "0.048 mm"], passing = ["0 %", "100 %"] } }
fines_content     = "0 %"
grading_tolerance = "10 %"
)";

std::string study_of(const std::string& loose, const std::string& contents, const std::string& soil = mixed_soil) {
    return reference_constants + soil + R"(
[study.s]
soil        = "mixture"
sample_size = { coarse_grains = 60, cell_width = 10, at_least = 150 }
sweep       = { fines_content = [)" +
           contents + R"(] }
[[study.s.stage]]
name     = "cloud"
do       = "pack"
porosity = 0.62
[[study.s.stage]]
name     = "loose"
do       = "compact"
pressure = "100 kPa"
)" + loose;
}

const std::string first = "prepare = { skeleton_first = true }\n";
const std::string as_another = R"(
void_ratio           = 0.75
void_ratio_tolerance = 0.02
if_unreachable       = "nearest"
prepared_as          = { fines_content = "10 %" }
)";

json numbers_of(const TempFolder& folder, const std::string& place) {
    return record::read_json(folder / ("run/studies/s/" + place + "/stage.json"));
}

class ConstantSkeleton : public testing::Test {
protected:
    void TearDown() override { set_thread_count(1); }
};

TEST_F(ConstantSkeleton, MadeFirstItKeepsItsVoidRatioAndThePureSoilsAreWhatTheyAre) {
    const TempFolder folder;
    run_text(study_of(first, R"("0 %", "8 %", "100 %")", soil_of_small_fines), folder.path());
    const json mixed = numbers_of(folder, "fc=8/loose");
    const double skeleton = mixed.at("skeleton").at("void_ratio");
    EXPECT_EQ(mixed.at("skeleton").at("widening"), 1);
    // The fines carry nothing: what remains is the tolerance of the servo, 0.1 % of the stress.
    EXPECT_NEAR(mixed.at("intergranular_void_ratio").get<double>(), skeleton, 1e-3);
    EXPECT_EQ(mixed.at("active_fines_fraction"), 0);
    EXPECT_GT(mixed.at("steps"), mixed.at("skeleton").at("steps"));
    const json sand = numbers_of(folder, "fc=0/loose"), silt = numbers_of(folder, "fc=100/loose");
    EXPECT_EQ(sand.at("skeleton").at("void_ratio"), sand.at("void_ratio"));
    EXPECT_TRUE(silt.at("skeleton").empty());
    EXPECT_LE(silt.at("unbalanced_force"), 1e-3);
}

TEST_F(ConstantSkeleton, MadeFirstAStopAnywhereChangesNoBit) {
    const std::string text = study_of(first, R"("20 %")");
    const TempFolder straight, broken;
    run_text(text, straight.path());
    int stops = 0;
    for (int pulses = 3;; pulses = pulses * 3 / 2 + 1) {
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int left = pulses;
        options.on_progress = [&](const run::Progress&) { stop = stop || --left <= 0; };
        if (run_text(text, broken.path(), options).outcome != record::Outcome::Stopped) {
            break;
        }
        ++stops;
        ASSERT_LT(stops, 100);
    }
    EXPECT_GE(stops, 3);
    const json expected = numbers_of(straight, "fc=20/loose"), found = numbers_of(broken, "fc=20/loose");
    EXPECT_EQ(found.at("state_hash"), expected.at("state_hash"));
    EXPECT_EQ(found.at("skeleton"), expected.at("skeleton"));
    EXPECT_EQ(found.at("steps"), expected.at("steps"));
}

TEST_F(ConstantSkeleton, PreparedAsAnotherASampleTakesWhatThatOneFound) {
    const TempFolder folder;
    set_thread_count(2);
    run_text(study_of(as_another, R"("30 %", "0 %", "10 %")"), folder.path());
    const json by = numbers_of(folder, "fc=10/loose"), taken = numbers_of(folder, "fc=30/loose");
    EXPECT_GE(by.at("preparation_trials"), 1);
    EXPECT_EQ(taken.at("prepared_as"), "s/fc=10");
    EXPECT_FALSE(taken.contains("preparation_trials")) << "it was not searched";
    EXPECT_GE(numbers_of(folder, "fc=0/loose").at("preparation_trials"), 1) << "fewer fines search for themselves";
}

TEST_F(ConstantSkeleton, ASampleThatIsRunAloneMakesForItselfWhatItIsPreparedAs) {
    const std::string text = study_of(as_another, R"("10 %", "30 %")");
    const TempFolder all, alone;
    run_text(text, all.path());
    run::RunOptions options;
    options.sample = "s/fc=30";
    run_text(text, alone.path(), options);
    EXPECT_EQ(numbers_of(alone, "fc=30/loose").at("state_hash"), numbers_of(all, "fc=30/loose").at("state_hash"));
    EXPECT_FALSE(std::filesystem::exists(alone / "run/studies/s/fc=10"));
    EXPECT_FALSE(std::filesystem::exists(alone / "run/studies/s/fc=30/loose/prepared-as"));
}

} // namespace
} // namespace suffuse::test
