// Presets and --set.
#include "suffuse/base/constants.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/case_for_tests.hpp"

#include <gtest/gtest.h>

namespace {

using namespace suffuse;
using namespace suffuse::casefile;
using namespace suffuse::casefile::testing;

const std::string with_presets = good_case + R"([[study.one.stage]]
name = "probe"
do = "detach"
[[study.one.stage]]
name = "erosion"
do = "erode"
[[study.one.stage]]
name = "shear"
do = "triaxial"
strain = "10 %"
[presets.quick]
particles = 5000
watch = 77
passes = 9
gradients = [0.2]
triaxial_strain = "3 %"
inertial_number = "loose"
unbalanced_force = 0.5
replicates = 2
probe_unbalanced_force = 1e-3
max_rate = "7 1/s"
)";

TEST(Presets, ChangeWhatTheyListAndNothingElse) {
    const Case plain = load(with_presets);
    EXPECT_EQ(plain.preset, "standard");
    EXPECT_EQ(plain.studies[0].particles, 20'000);
    const Case quick = load(with_presets, {"quick", {}});
    const Study& study = quick.studies[0];
    EXPECT_EQ(quick.preset, "quick");
    EXPECT_EQ(study.particles, 5000);
    EXPECT_EQ(study.replicates, 2);
    EXPECT_EQ(quick.balance.unbalanced_force, 0.5);
    EXPECT_EQ(std::get<packing::CompactSpec>(study.stages[1].spec).max_rate, 7);
    EXPECT_EQ(std::get<packing::CompactSpec>(study.stages[1].spec).pressure, 1e5);
    EXPECT_EQ(std::get<erosion::DetachStageSpec>(study.stages[2].spec).probe.watch, 77);
    EXPECT_EQ(std::get<erosion::DetachStageSpec>(study.stages[2].spec).gradients, std::vector<double>{0.2});
    EXPECT_EQ(std::get<erosion::ErodeSpec>(study.stages[3].spec).passes, 9);
    EXPECT_EQ(std::get<erosion::ErodeSpec>(study.stages[3].spec).probe.unbalanced_force, 1e-3);
    EXPECT_EQ(std::get<erosion::ErodeSpec>(study.stages[3].spec).gradient, 0.05);
    EXPECT_EQ(std::get<triaxial::TriaxialSpec>(study.stages[4].spec).strain, 0.03);
    EXPECT_EQ(std::get<triaxial::TriaxialSpec>(study.stages[4].spec).inertial_number, 1e-3);
}

TEST(Presets, ReplaceTheListOfASweep) {
    const std::string text = full_case + "[presets.few]\nfines_content = [\"15 %\"]\n";
    const Case c = load(text, {"few", {}});
    EXPECT_EQ(c.studies[0].variants.size(), 4U);
    EXPECT_EQ(c.studies[0].variants[0].soil->fines_content, 0.15);
}

TEST(Presets, AResolvedCaseRemembersItsPreset) {
    const Case quick = load(with_presets, {"quick", {}});
    EXPECT_EQ(load(resolved_toml(quick)).preset, "quick");
}

TEST(Presets, AreCheckedAlsoWhenTheyAreNotInForce) {
    const auto list = problems_of(good_case + "[presets.x]\nparticles = \"many\"\npressure = \"1 kPa\"\n");
    EXPECT_EQ(find_problem(list, "E205").line, 16);
    EXPECT_EQ(find_problem(list, "E203").line, 17);
}

TEST(Presets, AnUnknownOneOnTheCommandLineIsReported) {
    const Diagnostic found = find_problem(problems_of(with_presets, {"fast", {}}), "E404");
    EXPECT_EQ(found.file, "--preset");
    EXPECT_EQ(found.help, "known are standard, quick");
}

TEST(Presets, KeepTheStudiesThatTheyNameAlone) {
    const std::string two = good_case + "[study.two]\nsoil = \"sand\"\nparticles = 3000\n[[study.two.stage]]\nname = "
                                        "\"cloud\"\ndo = \"pack\"\n[presets.quick]\nstudies = [\"two\"]\n";
    EXPECT_EQ(load(two).studies.size(), 2U);
    const Case quick = load(two, {"quick", {}});
    ASSERT_EQ(quick.studies.size(), 1U);
    EXPECT_EQ(quick.studies[0].name, "two");
    const std::string wrong = good_case + "[presets.quick]\nstudies = [\"two\"]\n";
    const Diagnostic found = find_problem(problems_of(wrong, {"quick", {}}), "E408");
    EXPECT_EQ(found.line, 16);
    EXPECT_EQ(found.help, "known are one");
    const std::string number = good_case + "[presets.quick]\nstudies = [2]\n";
    EXPECT_EQ(find_problem(problems_of(number), "E205").line, 16);
}

TEST(Set, ChangesAnyKeyAfterThePreset) {
    const Case c = load(
        with_presets, {"quick",
                       {"study.one.particles=4000", "study.one.stage.erosion.gradient=0.1", "contact.friction=30 deg",
                        "fluid.viscosity = \"2 mPa*s\"", "study.one.stage.probe.gradients=[0, 0.3]",
                        "study.one.stage.erosion.detached.over=0.25", "soil.sand.fines.finer_than=0.3 mm"}}
    );
    EXPECT_EQ(c.studies[0].particles, 4000);
    EXPECT_EQ(std::get<erosion::ErodeSpec>(c.studies[0].stages[3].spec).gradient, 0.1);
    EXPECT_EQ(std::get<erosion::ErodeSpec>(c.studies[0].stages[3].spec).detached.over, 0.25);
    EXPECT_EQ(std::get<erosion::DetachStageSpec>(c.studies[0].stages[2].spec).gradients, (std::vector<double>{0, 0.3}));
    EXPECT_EQ(c.material.friction, radians(30));
    EXPECT_EQ(c.fluid.viscosity, 2e-3);
    EXPECT_EQ(c.studies[0].variants[0].soil->finer_than, 3e-4);
}

TEST(Set, ChangesThePresetInForce) {
    EXPECT_EQ(load(with_presets, {"quick", {"presets.quick.particles=3500"}}).studies[0].particles, 3500);
    const std::vector<std::string> both{"study.one.particles=4500", "presets.quick.particles=3500"};
    EXPECT_EQ(load(with_presets, {"quick", both}).studies[0].particles, 4500); // the key itself comes last
    EXPECT_EQ(load(with_presets, {"", {"preset=quick"}}).preset, "quick");
}

TEST(Set, OfAPresetThatIsNotInForceIsRefusedWithWhatToSetInstead) {
    const Diagnostic found = find_problem(problems_of(with_presets, {"", {"presets.quick.particles=3500"}}), "E405");
    EXPECT_EQ(found.file, "--set");
    EXPECT_NE(found.message.find("the preset in force is \"standard\""), std::string::npos) << found.message;
    EXPECT_NE(found.help.find("--preset quick"), std::string::npos);
    EXPECT_NE(found.help.find("presets.standard.particles"), std::string::npos);
}

/// good_case with what its study sweeps; a second study of the same soil sweeps nothing.
std::string sweeping(const std::string& table, bool has_second = false) {
    std::string text = good_case;
    text.insert(text.find("particles"), table + "\n");
    const std::size_t begin = good_case.find("[study.one]");
    std::string second = good_case.substr(begin);
    for (std::size_t at = 0; (at = second.find("study.one", at)) != std::string::npos;) {
        second.replace(at, 9, "study.two");
    }
    return text + (has_second ? "\n" + second : "");
}

TEST(Set, OfAKeyThatTheStudySweepsIsRefusedWithTheListToSet) {
    const std::string sweep =
        R"(sweep = { "stage.initial.pressure" = ["50 kPa", "60 kPa"], "contact.friction" = ["30 deg"], finer_than = ["0.2 mm"], seed = [3] })";
    for (const std::string set :
         {"study.one.stage.initial.pressure=\"70 kPa\"", "contact.friction=\"20 deg\"",
          "soil.sand.fines.finer_than=\"0.1 mm\"", "seed=4"}) {
        const Diagnostic found = find_problem(problems_of(sweeping(sweep), {"", {set}}), "E405");
        EXPECT_NE(found.message.find("the study \"one\" has values of its own for `"), std::string::npos)
            << set << "\n"
            << found.message;
        EXPECT_EQ(found.file, "--set");
    }
    const Diagnostic found =
        find_problem(problems_of(sweeping(sweep), {"", {"study.one.stage.initial.pressure=\"70 kPa\""}}), "E405");
    EXPECT_NE(found.help.find("'study.one.sweep.stage.initial.pressure=[VALUE, VALUE]'"), std::string::npos);
    const std::vector<Variant> set =
        load(sweeping(sweep), {"", {"study.one.sweep.stage.initial.pressure=[\"70 kPa\"]"}}).studies[0].variants;
    ASSERT_EQ(set.size(), 1U) << "the other keys of the sweep stay";
    EXPECT_EQ(std::get<packing::CompactSpec>(set[0].stages[1].spec).pressure, 7e4);
}

TEST(Set, OfAKeyThatOnlySomeStudiesSweepHoldsForTheOthers) {
    const std::string text = sweeping(R"(sweep = { "contact.friction" = ["30 deg"] })", true);
    const LoadOptions both{"", {"contact.friction=\"20 deg\""}};
    EXPECT_NEAR(load(text, both).studies[1].variants[0].material.friction, radians(20), 1e-12);
    EXPECT_NEAR(load(text, both).studies[0].variants[0].material.friction, radians(30), 1e-12);
    LoadOptions one = both;
    one.studies = {"one"};
    EXPECT_EQ(find_problem(problems_of(text, one), "E405").file, "--set");
}

TEST(Set, ARefinementThatCannotBeReadIsReportedOnce) {
    for (const std::string value : {"", "3", "{ of = \"void_ratio\", at = [\"initial\"] }", "{ key = 1 }"}) {
        const std::vector<Diagnostic> list = problems_of(good_case, {"", {"study.one.refine=" + value}});
        EXPECT_TRUE(std::ranges::none_of(list, [](const Diagnostic& d) { return d.code == "E406"; })) << value;
        EXPECT_FALSE(list.empty());
    }
}

TEST(Set, MistakesAreReportedOnTheirOwnText) {
    const auto problem = [](const std::string& text, const std::string& code) {
        return find_problem(problems_of(good_case, {"", {text}}), code);
    };
    EXPECT_EQ(problem("study.one.particles=few", "E205").column, 21);
    EXPECT_EQ(problem("study.one.particles=few", "E205").file, "--set");
    EXPECT_NE(problem("study.two.particles=5", "E405").message.find("known are one"), std::string::npos);
    EXPECT_NE(problem("study.one.stage.none.watch=5", "E405").message.find("no stage \"none\""), std::string::npos);
    EXPECT_EQ(problem("particles", "E405").line, 1);
    EXPECT_EQ(problem("a..b=1", "E405").line, 1);
    EXPECT_EQ(problem("study.one.particels=5", "E203").file, "--set");
    EXPECT_EQ(problem("study.one.stage=5", "E201").line, 5);
    EXPECT_EQ(problem("contact.modulus=5", "E310").source_line, "contact.modulus=5");
    EXPECT_EQ(problem("title=\xfc", "E100").file, "--set");
}

} // namespace
