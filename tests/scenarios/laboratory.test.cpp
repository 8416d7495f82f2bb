// The tests of a laboratory as stages: what they leave in stage.json and in the report, and that they go on.

#include <gtest/gtest.h>

#include "tests/support/run_text.hpp"
#include <atomic>
#include <string>
#include <vector>

namespace suffuse::test {
namespace {

std::string stage(const std::string& name, const std::string& keys) {
    return "[[study.s.stage]]\nname = \"" + name + "\"\nfrom = \"settled\"\ninertial_number = 4e-3\n" + keys;
}

/// Each test once, from one state; the constants end with those of the fluid.
std::string laboratory() {
    return reference_constants + "bulk_modulus = \"2.2 GPa\"\n" + reference_soil() + study_of_packing("packing500") +
           stage("extended", "do = \"triaxial\"\ndirection = \"extension\"\nstrain = \"2 %\"\n") +
           stage("one-dimensional", "do = \"oedometer\"\nstresses = [\"300 kPa\", \"100 kPa\"]\n") +
           stage("all-around", "do = \"isotropic\"\nstresses = [\"300 kPa\", \"100 kPa\", \"200 kPa\"]\n") +
           stage("plane", "do = \"plane-strain\"\nstrain = \"2 %\"\n") +
           stage("sheared", "do = \"shear\"\nhold = \"stress\"\nstrain = \"3 %\"\n") +
           "[[study.s.stage]]\nname = \"stiff\"\nfrom = \"settled\"\n" +
           "do = \"stiffness\"\nmeasure = [\"skempton-b\"]\n" +
           stage("cycled", "do = \"cyclic\"\ncsr = 0.15\ncycles = 2\n");
}

TEST(Laboratory, EachTestLeavesItsNumbersAndItsFigure) {
    const TempFolder folder;
    run_text(laboratory(), folder.path());
    EXPECT_LT(stage_of(folder.path(), "extended").at("response").at("peak_deviator"), 0);
    const nlohmann::json oedometer = stage_of(folder.path(), "one-dimensional");
    EXPECT_GT(oedometer.at("k0"), 0.2);
    EXPECT_LT(oedometer.at("k0"), 0.9);
    EXPECT_GT(oedometer.at("compression_index"), oedometer.at("swelling_index"));
    EXPECT_GT(oedometer.at("swelling_index"), 0);
    EXPECT_NEAR(oedometer.at("stress").at(2).at(2).get<double>(), 1e5, 1e3); // at rest under the last stress
    const nlohmann::json isotropic = stage_of(folder.path(), "all-around");
    EXPECT_TRUE(isotropic.at("k0").is_null());
    EXPECT_NEAR(isotropic.at("mean_stress").get<double>(), 2e5, 2e3);
    EXPECT_GT(stage_of(folder.path(), "plane").at("response").at("friction_angle"), 0.3);
    const nlohmann::json sheared = stage_of(folder.path(), "sheared"), cycled = stage_of(folder.path(), "cycled");
    EXPECT_NEAR(sheared.at("normal_stress").get<double>(), 1e5, 2e3);
    EXPECT_EQ(sheared.at("rows").back().at("void_ratio"), sheared.at("void_ratio"));
    EXPECT_EQ(cycled.at("cycles"), 2);
    EXPECT_TRUE(cycled.at("cycles_to_liquefaction").is_null());
    EXPECT_GT(cycled.at("rows").size(), 40U);
    EXPECT_GT(cycled.at("skempton_b"), 0.95);
    EXPECT_LT(cycled.at("skempton_b"), 1);
    const nlohmann::json stiff = stage_of(folder.path(), "stiff");
    EXPECT_TRUE(stiff.at("flaws").empty());
    EXPECT_LT(stiff.at("shear_modulus"), stiff.at("mean_field_shear"));
    EXPECT_EQ(stiff.at("stiffness").size(), 6U);
    EXPECT_EQ(stiff.at("measured").at("skempton-b").at("skempton_b"), stiff.at("skempton_b"));
    EXPECT_NEAR(stiff.at("skempton_b").get<double>(), cycled.at("skempton_b").get<double>(), 0.005);
    for (const char* id :
         {"own-triaxial", "own-compression", "own-shear", "own-cyclic", "own-stiffness", "own-stiffness-strain"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / ("run/figures/" + std::string(id) + ".csv"))) << id;
    }
}

TEST(Laboratory, ATestThatIsStoppedGoesOnToTheSameBits) {
    const TempFolder straight, broken;
    run_text(laboratory(), straight.path());
    int stops = 0;
    for (int pulses = 20;; pulses *= 2) { // ever later
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int left = pulses;
        options.on_progress = [&](const run::Progress&) { stop = --left <= 0 || stop; };
        if (run_text(laboratory(), broken.path(), options).outcome != record::Outcome::Stopped) {
            break;
        }
        ASSERT_LT(++stops, 100);
    }
    EXPECT_GE(stops, 2);
    for (const char* name : {"extended", "one-dimensional", "all-around", "plane", "sheared", "cycled"}) {
        EXPECT_EQ(stage_of(straight.path(), name).at("state_hash"), stage_of(broken.path(), name).at("state_hash"))
            << name;
    }
    EXPECT_EQ(stage_of(straight.path(), "stiff").at("stiffness"), stage_of(broken.path(), "stiff").at("stiffness"));
}

} // namespace
} // namespace suffuse::test
