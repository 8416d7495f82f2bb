// Cases that calibrate: what [calibrate] means, what is wrong with it, and the samples that it makes.

#include "suffuse/casefile/calibration_case.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/sweep_value.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <cmath>
#include <fstream>

namespace suffuse::casefile {
namespace {

const std::string good_calibration = R"(schema = 1
title = "a sand"
seed = 5
[contact]
modulus = "300 MPa"
[soil.sand]
psd = { d = ["0.1 mm", "0.2 mm"], passing = ["0 %", "100 %"] }
[calibrate]
soil = "sand"
particles = 400
samples = 20
targets = [
  { file = "drained.csv", sample = "TMD2", pressure = "100 kPa", weight = 2 },
  { name = "oedo", file = "oedometer.csv", test = "oedometer", pressure = "10 kPa" },
  { name = "later", file = "drained.csv", pressure = "200 kPa", held_out = true, void_ratio_of = "TMD2" },
]
unknowns = { "contact.friction" = ["20 deg", "40 deg"], "contact.modulus" = ["50 MPa", "2 GPa", "log"], void_ratio = [0.6, 0.7] }
constraints = ["contact.friction >= 25 deg", "contact.friction <= 2 * void_ratio.TMD2"]
)";

std::string changed_calibration(const std::string& what, const std::string& instead) {
    std::string text = good_calibration;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), instead);
}

CalibrationCase calibration_in(const std::string& text) {
    const test::TempFolder folder;
    std::ofstream(folder / "case.toml") << text;
    return load_calibration((folder / "case.toml").string());
}

/// "E201: message" of every problem.
std::string problems_in(const std::string& text) {
    try {
        calibration_in(text);
    } catch (const CaseProblems& found) {
        std::string all;
        for (const Diagnostic& problem : found.problems) {
            all += problem.code + ": " + problem.message + "\n";
        }
        return all;
    }
    return "none";
}

} // namespace

TEST(CalibrationCase, SaysWhatIsSoughtAndFromWhichTests) {
    const CalibrateSpec spec = calibration_in(good_calibration).spec;
    ASSERT_EQ(spec.targets.size(), 3U);
    EXPECT_EQ(spec.targets[0].name, "TMD2") << "the test of its file";
    EXPECT_TRUE(spec.targets[0].file.ends_with("/drained.csv"));
    EXPECT_EQ(spec.targets[0].pressure, 100e3);
    EXPECT_EQ(spec.targets[0].weight, 2);
    EXPECT_EQ(spec.targets[1].test, CalibrateTest::Oedometer);
    EXPECT_TRUE(spec.targets[2].is_held_out);
    ASSERT_EQ(spec.unknowns.size(), 4U);
    EXPECT_EQ(spec.unknowns[2].key, "void_ratio.TMD2");
    EXPECT_EQ(spec.unknowns[3].key, "void_ratio.oedo") << "each target has its own";
    EXPECT_EQ(spec.unknowns[3].most, 0.7);
    EXPECT_EQ(void_ratio_of(spec, spec.targets[1]), 3);
    EXPECT_EQ(void_ratio_of(spec, spec.targets[2]), 2) << "shared with TMD2";
    EXPECT_DOUBLE_EQ(value_at(spec.unknowns[0], 0.25), radians(25));
    EXPECT_NEAR(value_at(spec.unknowns[1], 0.5), std::sqrt(50e6 * 2e9), 1) << "the middle of the decades";
}

TEST(CalibrationCase, TakesTheVoidRatioOfItsOnlyDensityByTheNameOfTheTargetToo) {
    std::string text = changed_calibration("name = \"oedo\",", "name = \"oedo\", void_ratio_of = \"TMD2\",");
    text.replace(text.find(", void_ratio = ["), 14, ", \"void_ratio.TMD2\" =");
    const CalibrateSpec spec = calibration_in(text).spec;
    ASSERT_EQ(spec.unknowns.size(), 3U) << "no second one that no sample has";
    EXPECT_EQ(void_ratio_of(spec, spec.targets[1]), 2);
}

TEST(CalibrationCase, ComparesUnknownsInItsConstraints) {
    const CalibrateSpec spec = calibration_in(good_calibration).spec;
    ASSERT_EQ(spec.constraints.size(), 2U);
    EXPECT_TRUE(meets(spec.constraints[0], spec, {radians(30), 1e8, 0.65, 0.65}));
    EXPECT_FALSE(meets(spec.constraints[0], spec, {radians(24), 1e8, 0.65, 0.65}));
    EXPECT_TRUE(meets(spec.constraints[1], spec, {1.2, 1e8, 0.61, 0.65}));
    EXPECT_FALSE(meets(spec.constraints[1], spec, {1.2, 1e8, 0.59, 0.65}));
}

TEST(CalibrationCase, MakesSamplesThatAreStudies) {
    const CalibrationCase what = calibration_in(good_calibration);
    const CalibrationSample first{0, 7, {0.5, 0.5, 0.25, 0}}, second{1, 7, {0.5, 0.5, 0.25, 1}};
    const Case samples = case_of_samples(what, {first, second});
    ASSERT_EQ(samples.studies.size(), 2U);
    EXPECT_EQ(samples.mode, dem::Mode::Fast);
    const Variant& one = samples.studies[0].variants.at(0);
    EXPECT_EQ(samples.studies[0].name, "TMD2-0007");
    EXPECT_EQ(one.particles, 400);
    EXPECT_NEAR(one.material.friction, radians(30), 1e-6);
    EXPECT_NEAR(one.material.modulus, std::sqrt(50e6 * 2e9), 1e3) << "six digits";
    const auto& compact = std::get<packing::CompactSpec>(one.stages.at(1).spec);
    EXPECT_NEAR(compact.void_ratio.value_or(0), 0.625, 1e-6);
    const auto& test = std::get<triaxial::TriaxialSpec>(one.stages.at(2).spec);
    EXPECT_NEAR(test.strain, -1.02 * std::log(0.9), 1e-12) << "of a length that shrinks by 10 %, and some more";
    const Variant& other = samples.studies[1].variants.at(0);
    EXPECT_NE(one.seed, other.seed) << "scatter between samples is part of what is learned";
    EXPECT_NEAR(std::get<packing::CompactSpec>(other.stages.at(1).spec).void_ratio.value_or(0), 0.7, 1e-6);
    EXPECT_EQ(verb_of(other.stages.at(2).spec), "oedometer");
}

TEST(CalibrationCase, NeedsNoModulusOfHertzMindlinWhereThatIsSought) {
    std::string text = changed_calibration("modulus = \"300 MPa\"", "law = \"hertz-mindlin\"\npoisson = 0.2");
    text.replace(text.find("\"50 MPa\", \"2 GPa\""), 17, "\"5 GPa\", \"20 GPa\"");
    const CalibrationCase what = calibration_in(text);
    const Case samples = case_of_samples(what, {{0, 1, {0.5, 1, 0.5, 0.5}}});
    EXPECT_NEAR(samples.studies[0].variants.at(0).material.modulus, 20e9, 1e4) << "of the sample";
}

TEST(CalibrationCase, KeepsTheVoidRatioOfTheModelWhereItIsFixed) {
    std::string text = changed_calibration("samples = 20", "samples = 20\nfix_void_ratio = true");
    text.replace(text.find(", void_ratio = [0.6, 0.7]"), 25, "");
    text.replace(text.find("constraints"), std::string::npos, "");
    EXPECT_NE(problems_in(text).find("needs the `void_ratio` of every target"), std::string::npos);
    for (std::size_t at = 0; (at = text.find("kPa\"", at)) != std::string::npos; at += 10) {
        text.insert(at + 4, ", void_ratio = 0.66");
    }
    const CalibrationCase what = calibration_in(text);
    EXPECT_EQ(what.spec.unknowns.size(), 2U);
    EXPECT_EQ(void_ratio_of(what.spec, what.spec.targets[0]), -1);
    const Case samples = case_of_samples(what, {{0, 1, {0.5, 0.5}}});
    EXPECT_EQ(std::get<packing::CompactSpec>(samples.studies[0].variants[0].stages[1].spec).void_ratio, 0.66);
}

TEST(CalibrationCase, ReportsWhatIsWrong) {
    const auto expect = [](const std::string& what, const std::string& instead, const std::string& problem) {
        EXPECT_NE(problems_in(changed_calibration(what, instead)).find(problem), std::string::npos)
            << instead << " gave " << problems_in(changed_calibration(what, instead));
    };
    expect("[\"20 deg\", \"40 deg\"]", "[\"40 deg\", \"20 deg\"]", "its first end must be the lower one");
    expect("[\"20 deg\", \"40 deg\"]", "[\"20 deg\", \"40 kPa\"]", "its ends are of two dimensions");
    expect("[0.6, 0.7]", "[0, 0.7, \"log\"]", "with \"log\" both ends must be above 0");
    expect("[0.6, 0.7]", "0.7", "needs ranges in its table");
    expect("contact.friction >=", "contact.cohesion >=", "is no constraint of these unknowns");
    expect("name = \"oedo\"", "name = \"TMD2\"", "two targets are called \"TMD2\"");
    expect("void_ratio_of = \"TMD2\"", "void_ratio_of = \"TMD3\"", "which has no void ratio of its own");
    expect(
        "void_ratio = [0.6, 0.7] }", "\"void_ratio.later\" = [0.6, 0.7] }", "`void_ratio.later`: no target of this name"
    );
    expect(", void_ratio_of = \"TMD2\"", "", "nothing gives the void ratio of \"later\"");
    expect("\"contact.modulus\" = [", "\"contact.modulos\" = [", "unknown key `modulos`");
    expect("soil = \"sand\"", "soil = \"clay\"", "there is no soil \"clay\"");
    expect("[calibrate]", "[calibrat]", "has no [calibrate]");
    expect("samples = 20", "sampels = 20", "unknown key `sampels`");
}

TEST(CalibrationCase, ExamplesLoad) {
    int examples = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator(test::in_checkout("examples"))) {
        if (file.path().extension() == ".toml" && calibrates(file.path().string())) {
            ++examples;
            CalibrationCase what;
            ASSERT_NO_THROW(what = load_calibration(file.path().string())) << file.path();
            for (const Diagnostic& warning : what.warnings) { // narrow cells, and soft grains at one end of the range
                EXPECT_TRUE(warning.code == "W602" || warning.code == "W603") << render({warning});
            }
        }
    }
    EXPECT_GE(examples, 1);
}

TEST(CalibrationCase, IsCheckedByARunAsWell) {
    try {
        load_case_text(changed_calibration("samples = 20", "samples = 2"), "case.toml", ".");
        FAIL() << "it has no study";
    } catch (const CaseProblems& found) {
        ASSERT_EQ(found.problems.size(), 2U);
        EXPECT_NE((found.problems[0].help + found.problems[1].help).find("suffuse calibrate CASE"), std::string::npos);
    }
}

TEST(CalibrationCase, MayHaveSeedsInASweep) {
    std::string text = good_calibration.substr(0, good_calibration.find("[calibrate]"));
    text += R"([study.s]
soil = "sand"
particles = 300
sweep = { seed = [3, 4] }
[[study.s.stage]]
name = "cloud"
do = "pack"
)";
    const Case swept = load_case_text(text, "case.toml", ".").value;
    EXPECT_EQ(swept.studies[0].variants.at(0).seed, 3U);
    EXPECT_EQ(swept.studies[0].variants.at(1).seed, 4U);
    const std::string wrong = text.replace(text.find("[3, 4]"), 6, "[3, -4]");
    EXPECT_THROW(load_case_text(wrong, "case.toml", "."), CaseProblems);
}

} // namespace suffuse::casefile
