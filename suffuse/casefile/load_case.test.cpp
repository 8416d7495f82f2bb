#include "suffuse/casefile/load_case.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/schema.hpp"
#include "suffuse/casefile/stage_list.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/contact/springs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <random>
#include <set>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

template <class Spec>
const Spec& spec_of(const Case& c, const std::string& study, const std::string& stage) {
    for (const Study& s : c.studies) {
        for (const Stage& t : s.stages) {
            if (s.name == study && t.name == stage) {
                return std::get<Spec>(t.spec);
            }
        }
    }
    throw std::runtime_error("no stage " + stage);
}

TEST(LoadCase, EveryValueReachesItsSpecInSi) {
    const Case c = load(full_case);
    EXPECT_EQ(c.seed, 42U);
    EXPECT_EQ(c.material.density, 2700);
    EXPECT_EQ(c.material.modulus, 1e9);
    EXPECT_EQ(c.material.friction, radians(33.3));
    EXPECT_EQ(c.material.rolling_friction, -1);
    EXPECT_EQ(c.material.adhesion_shear, 2000);
    EXPECT_EQ(c.damping, 0.25);
    EXPECT_EQ(c.balance.stress_error, 0.001);
    EXPECT_EQ(c.fluid.viscosity, 1.002e-3);
    EXPECT_EQ(c.soils.at("whole").finer_than, 150e-6);
    EXPECT_TRUE(c.soils.at("whole").report_kenney_lau);
    EXPECT_TRUE(c.soils.at("split").kenney_lau);
    EXPECT_EQ(c.soils.at("two").fines_content, 0.2);
    ASSERT_TRUE(c.soils.at("two").fines);
    EXPECT_EQ(c.soils.at("two").fines->diameter, (std::vector<double>{5e-5, 6e-5}));
    EXPECT_EQ(c.soils.at("whole").whole->passing, (std::vector<double>{0, 0.5, 1}));
    EXPECT_FALSE(c.soils.at("whole").measured);
    EXPECT_EQ(c.soils.at("part").whole->passing, (std::vector<double>{0, 1}));
    EXPECT_EQ(c.soils.at("part").measured->passing, (std::vector<double>{0.1, 0.6, 0.9}));
    EXPECT_EQ(c.soils.at("stand-in").fines_content, 0.6);
    EXPECT_EQ(c.soils.at("stand-in").surrogate->size_ratio, 3);
    EXPECT_EQ(c.soils.at("stand-in").measured->passing, (std::vector<double>{0.1, 0.6, 0.9}));
    EXPECT_EQ(c.studies.size(), 4U);
    const auto& compact = spec_of<packing::CompactSpec>(c, "main", "initial");
    EXPECT_EQ(compact.prepare.friction, radians(5));
    EXPECT_EQ(compact.prepare.adhesion_shear, 2e6);
    EXPECT_EQ(compact.void_ratio, 0.7);
    EXPECT_EQ(compact.time_step, 1e-8);
    const auto& probe = spec_of<erosion::DetachStageSpec>(c, "main", "probe");
    EXPECT_EQ(probe.gradients, (std::vector<double>{0, 0.05}));
    EXPECT_FALSE(probe.probe.hold_coarse);
    EXPECT_EQ(probe.detached.by, erosion::DetachBy::Displacement);
    EXPECT_EQ(probe.detached.over_diameters, 0.1);
    EXPECT_NEAR(norm(probe.direction), 1, 1e-15); // rounding of one division
    EXPECT_NEAR(probe.direction.z, -2.0 / 3, 1e-15);
    const auto& erode = spec_of<erosion::ErodeSpec>(c, "main", "erosion");
    EXPECT_EQ(erode.direction, (Vec3{0, -1, 0}));
    EXPECT_EQ(erode.detached.over_speed, 1e-5);
    EXPECT_EQ(erode.passes_constriction, erosion::ConstrictionSize::Median);
    EXPECT_EQ(erode.transport_distance, 3e-3);
    EXPECT_EQ(erode.merge, pores::VoidMerge::Overlap);
    ASSERT_TRUE(erode.forced);
    EXPECT_EQ(erode.forced->max_contacts, 2);
    const auto& shear = spec_of<triaxial::TriaxialSpec>(c, "main", "shear");
    EXPECT_EQ(shear.path, triaxial::Path::Undrained);
    EXPECT_EQ(shear.axis, 0);
    EXPECT_EQ(shear.inertial_number, 1e-4);
    const auto& widened = spec_of<triaxial::TriaxialSpec>(c, "main", "widened");
    EXPECT_EQ(widened.path, triaxial::Path::Proportional);
    EXPECT_EQ(widened.strain_ratio, -0.5);
    EXPECT_EQ(widened.stress_ratio, 0.5);
    const auto& import = spec_of<ImportSpec>(c, "other", "start");
    EXPECT_EQ(import.cell(0, 1), 1e-4);
    EXPECT_EQ(import.cell(1, 0), 0);
    EXPECT_EQ(import.unit, 1e-3);
    EXPECT_EQ(import.max_overlap, 0.05);
    EXPECT_TRUE(std::filesystem::path(import.path).is_absolute());
    EXPECT_TRUE(import.place.starts_with("case.toml:")) << import.place;
    const auto& settle = spec_of<dem::SettleSpec>(c, "other", "settled");
    EXPECT_EQ(settle.loading.axis[0].control, cell::Control::Stress);
    EXPECT_EQ(settle.loading.axis[2].value, 5e4);
    EXPECT_EQ(settle.loading.axis[1].control, cell::Control::StrainRate);
    EXPECT_EQ(settle.loading.axis[1].value, 0);
    EXPECT_EQ(settle.loading.servo.mass, 0.0063);
    const auto& advance = spec_of<dem::AdvanceSpec>(c, "other", "go");
    EXPECT_EQ(advance.loading.axis[1].control, cell::Control::Stress);
    EXPECT_EQ(advance.loading.axis[2].value, 2);
    EXPECT_EQ(advance.time_step, 0);
    const auto& turn = spec_of<dem::AdvanceSpec>(c, "other", "turn");
    ASSERT_TRUE(turn.loading.velocity_gradient);
    EXPECT_EQ((*turn.loading.velocity_gradient)(0, 1), 25);
    EXPECT_EQ(c.output.checkpoint, 300);
    EXPECT_EQ(c.output.snapshots.when, Snapshots::When::Strain);
    EXPECT_EQ(c.output.snapshots.every, 0.01);
    EXPECT_TRUE(c.report.reversed_size_axis);
    EXPECT_TRUE(c.report.dilation_up);
    EXPECT_EQ(c.report.overlay.size(), 1U);
}

TEST(LoadCase, TheTitlePageNamesProjectAndAuthorOnlyWhereTheCaseDoes) {
    const Case without = load_case_text(good_case, "case.toml", data_folder()).value;
    EXPECT_EQ(resolved_toml(without).find("project"), std::string::npos) << "runs of before stay those of their cases";
    const Case with =
        load_case_text(good_case + "[report]\nproject = \"Dyke\"\nauthor = \"A. E.\"\n", "case.toml", data_folder())
            .value;
    EXPECT_EQ(with.report.project, "Dyke");
    const Case again = load_case_text(resolved_toml(with), "case.toml", data_folder()).value;
    EXPECT_EQ(again.report.author, "A. E.");
}

TEST(LoadCase, AKeyOfEarlierVersionsIsAWarningSoThatOldRunsAreStillRead) {
    const LoadedCase loaded = load_case_text(good_case + "[report]\nlanguage = \"en\"\n", "case.toml", data_folder());
    const Diagnostic warning = find_problem(loaded.warnings, "W208");
    EXPECT_TRUE(warning.is_warning);
    EXPECT_EQ(warning.line, 16);
    EXPECT_EQ(resolved_toml(loaded.value).find("language"), std::string::npos);
}

TEST(LoadCase, WrittenBackWithAllDefaultsItIsTheSameCase) {
    const std::string once = resolved_toml(load(full_case));
    const std::string twice = resolved_toml(load_case_text(once, "resolved.toml", "/nowhere").value);
    EXPECT_EQ(once, twice);
    EXPECT_NE(once.find("friction = \"33.3 deg\""), std::string::npos);
    EXPECT_NE(once.find("noise_quantile = 0.999"), std::string::npos) << "a default is missing";
}

// Numbers of any size keep their bits on the way out and in: the printed text is the same only if they do.
TEST(LoadCase, AnyNumberSurvivesWritingAndReading) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> power(-6, 6);
    for (int trial = 0; trial < 50; ++trial) {
        Case c = load(full_case);
        const auto draw = [&] { return std::pow(10.0, power(random)); };
        c.material.density = draw();
        c.material.modulus = 1e9 + draw();
        c.material.friction = 1.5 / (1 + draw());
        c.material.rolling_friction = -draw();
        c.fluid.viscosity = draw();
        c.balance.unbalanced_force = draw();
        c.output.checkpoint = draw();
        auto& probe = std::get<erosion::DetachStageSpec>(c.studies[0].stages[2].spec);
        probe.direction = Vec3{draw(), -draw(), draw()};
        probe.direction = probe.direction / norm(probe.direction);
        probe.gradients = {draw(), draw()};
        const Case back = load_case_text(resolved_toml(c), "resolved.toml", "/nowhere").value;
        ASSERT_EQ(resolved_toml(back), resolved_toml(c));
        EXPECT_EQ(back.material.density, c.material.density);
        EXPECT_EQ(back.material.friction, c.material.friction);
        EXPECT_EQ(back.fluid.viscosity, c.fluid.viscosity);
        EXPECT_EQ(back.output.checkpoint, c.output.checkpoint);
        EXPECT_EQ(std::get<erosion::DetachStageSpec>(back.studies[0].stages[2].spec).direction, probe.direction);
    }
}

void collect_keys(const Node& table, std::set<std::string>& keys) {
    for (const auto& [key, place, value] : table.entries) {
        keys.insert(key);
        collect_keys(value, keys);
        for (const Node& item : value.items) {
            collect_keys(item, keys);
        }
    }
}

TEST(LoadCase, EveryKeyOfTheSchemaIsWrittenBack) {
    std::set<std::string> written;
    collect_keys(tree_of(load(full_case)), written);
    for (const contact::Spring& spring : contact::springs) { // each has keys of its own
        const std::string law = fmt::format("[contact]\nlaw = \"{}\"\nmodulus = \"70 GPa\"\n", spring.words.name);
        collect_keys(tree_of(load(good_case + law)), written);
    }
    const std::string title_page = "[report]\nproject = \"Dyke\"\nauthor = \"A. E.\"\n";
    collect_keys(tree_of(load(good_case + keys_of_weight + title_page)), written);
    for (const Key& key : schema()) {
        // `preset` was applied; `settle` writes its stresses per axis, `detach` all its gradients; a calibration's
        // samples are cases without it.
        const bool is_input_only = key.table == "presets.*" || key.table.starts_with("calibrate") ||
                                   (key.table.empty() && key.name == "preset") || key.table == "stage.detach.gradients";
        if (!is_input_only) {
            EXPECT_TRUE(written.contains(key.name)) << key_place(key);
        }
    }
}

/// What `full_case` leaves as it is by default, and so is not written back.
const std::string rare_keys = R"([[study.one.stage]]
name = "moved"
do = "advance"
steps = 1
stress = ["100 kPa", "100 kPa", "100 kPa"]
servo = { max_rate = "60 1/s" }
[[study.one.stage]]
name = "flow"
do = "flow"
gradient = 0.1
solver = "resolved"
resolve_tolerance = 1e-5
[[study.one.stage]]
name = "probe"
do = "detach"
detached = { by = "velocity", rule = "above", over = "1e-5 m/s" }
[[study.one.stage]]
name = "erosion"
do = "erode"
solver = "resolved"
resolve = 8
resolve_tolerance = 1e-5
[[study.one.stage]]
name = "settled"
do = "settle"
pressure = "100 kPa"
shear_stresses = "released"
)";

// That another verb writes a key of this name is not enough.
TEST(LoadCase, EveryKeyOfAVerbIsWrittenBackByIt) {
    std::set<std::string> written;
    for (const std::string& text : {full_case, good_case + rare_keys, good_case + keys_of_weight}) {
        for (const Study& study : load(text).studies) {
            for (const Stage& stage : study.stages) {
                std::set<std::string> keys;
                collect_keys(write_stage(stage), keys);
                for (const std::string& key : keys) {
                    written.insert(fmt::format("stage.{} {}", verb_of(stage.spec), key));
                }
            }
        }
    }
    for (const Key& key : schema()) {
        const std::string table = key.table.substr(0, key.table.find('.', 6));
        const bool is_of_verb = table.starts_with("stage.") && find_verb(table.substr(6)) != nullptr;
        // `settle` writes its stresses per axis, `detach` all its gradients.
        const bool is_input_only =
            key.table == "stage.detach.gradients" || (table == "stage.settle" && key.name == "pressure");
        if (is_of_verb && !is_input_only) {
            EXPECT_TRUE(written.contains(table + " " + key.name)) << key_place(key);
        }
    }
}

TEST(LoadCase, AGradientMayBeHeadOverLength) {
    std::string text = full_case;
    const std::string bare = "gradient = 0.05", quotient = "gradient = \"12 m / 30 m\"";
    ASSERT_NE(text.find(bare), std::string::npos);
    text.replace(text.find(bare), bare.size(), quotient);
    EXPECT_NE(resolved_toml(load(text)).find("gradient = 0.4"), std::string::npos);
}

TEST(LoadCase, ARunOfBeforeTheConductanceCouldBeChosenGoesOnWithYades) {
    const Case now = load(good_case);
    EXPECT_EQ(now.fluid.conductance, flow::Conductance::Bounded);
    const std::string line = "conductance = \"bounded\"\n";
    std::string before = resolved_toml(now);
    ASSERT_NE(before.find(line), std::string::npos);
    before.erase(before.find(line), line.size());
    const Case then = load_case_text(before, "case.resolved.toml", data_folder()).value;
    EXPECT_EQ(then.fluid.conductance, flow::Conductance::Yade);
    EXPECT_EQ(resolved_toml(then), before); // by which its folder knows it
    EXPECT_EQ(load_case_text(resolved_toml(now), "x", data_folder()).value.fluid.conductance, now.fluid.conductance);
}

TEST(LoadCase, UnitsMakeNoDifference) {
    const Case a = load(good_case + "[fluid]\nviscosity = \"1 mPa*s\"\ndensity = \"1000 kg/m^3\"\n");
    const Case b = load(good_case + "[fluid]\nviscosity = \"1e-3 Pa*s\"\ndensity = \"1 g/cm^3\"\n");
    EXPECT_EQ(resolved_toml(a), resolved_toml(b));
}

TEST(LoadCase, ExamplesLoadWithEveryPreset) {
    int examples = 0;
    for (const auto& folder : std::filesystem::directory_iterator(test::in_checkout("examples"))) {
        const std::string file = (folder.path() / "case.toml").string();
        if (!std::filesystem::exists(file)) {
            continue;
        }
        ++examples;
        for (const std::string preset : {"", "standard"}) {
            LoadedCase loaded;
            ASSERT_NO_THROW(loaded = load_case(file, {preset, {}})) << file;
            EXPECT_EQ(
                resolved_toml(load_case_text(resolved_toml(loaded.value), "r", "/nowhere").value),
                resolved_toml(loaded.value)
            );
            for (const Diagnostic& warning : loaded.warnings) {
                // A narrow cell: quick presets are small. The study of the second erosion goes far beyond the critical
                // gradient, to see whether active grains ever move.
                const std::filesystem::path name = folder.path().filename();
                const bool expected = warning.code == "W602" || (warning.code == "W604" && name == "second-erosion");
                EXPECT_TRUE(expected) << render({warning});
            }
        }
    }
    EXPECT_GE(examples, 4);
}

TEST(LoadCase, TheMainExampleIsThePapersScenario) {
    const Case c = load_case(test::in_checkout("examples/fontainebleau-2016/case.toml"), {"paper", {}}).value;
    EXPECT_EQ(c.preset, "paper");
    EXPECT_EQ(c.studies.at(0).name, "erosion");
    EXPECT_EQ(c.studies[0].variants.at(0).particles, 10'000);
    EXPECT_EQ(c.studies[0].variants[0].soil->finer_than, 2.6e-4);
    EXPECT_EQ(spec_of<erosion::ErodeSpec>(c, "erosion", "erosion").gradient, 0.05);
    EXPECT_EQ(spec_of<triaxial::TriaxialSpec>(c, "erosion", "shear-after").strain, 0.2);
    EXPECT_EQ(spec_of<triaxial::TriaxialSpec>(c, "erosion", "deviatoric").stress_ratio, 0.75);
    EXPECT_EQ(c.material.modulus, 356e6);
    EXPECT_EQ(c.material.friction, radians(37));
}

TEST(LoadCase, AMissingFileIsAReadingError) {
    EXPECT_THROW(load_case("/nowhere/case.toml"), IoError);
    EXPECT_THROW(load_case("/tmp"), IoError);
}

} // namespace
