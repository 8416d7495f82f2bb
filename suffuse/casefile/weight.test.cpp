// [gravity], and what stages with water make of it.

#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/case_for_tests.hpp"
#include "suffuse/casefile/dependencies.hpp"
#include "suffuse/casefile/weight_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::casefile {
namespace {

using testing::erode_stage;
using testing::find_problem;
using testing::good_case;
using testing::load;
using testing::problems_of;
using testing::replaced;

const std::string detach_stage = "[[study.one.stage]]\nname = \"probe\"\ndo = \"detach\"\n";
const std::string gravity = "[gravity]\ndown = \"-z\"\n";

std::string weighed(const std::string& stages) {
    return replaced(good_case, "[soil.sand]", gravity + "[soil.sand]") + stages;
}

template <class Spec>
Spec last_spec(const Case& c) {
    return std::get<Spec>(c.studies.front().variants.front().stages.back().spec);
}

TEST(Gravity, IsNoneWhereTheTableIsNotThere) {
    const Case c = load(good_case + erode_stage);
    EXPECT_FALSE(c.gravity);
    EXPECT_FALSE(last_spec<erosion::ErodeSpec>(c).probe.gravity);
    EXPECT_EQ(resolved_toml(c).find("[gravity]"), std::string::npos);
}

TEST(Gravity, ReachesEveryStageThatProbesFinesAndComesBackFromTheResolvedCase) {
    const Case c = load(weighed(detach_stage + erode_stage));
    const Case back = load(resolved_toml(c));
    for (const Case* one : {&c, &back}) {
        ASSERT_TRUE(one->gravity);
        EXPECT_EQ(one->gravity->down, (Vec3{0, 0, -1}));
        EXPECT_EQ(one->gravity->acceleration, 9.81);
        EXPECT_TRUE(last_spec<erosion::ErodeSpec>(*one).probe.gravity);
    }
    EXPECT_EQ(resolved_toml(c), resolved_toml(back));
    EXPECT_EQ(resolved_toml(c).find("ramp ="), std::string::npos); // of a probe without weight
}

TEST(Gravity, IsMentionedOnceWhereAStageProbesWhatWaterTakes) {
    EXPECT_EQ(weight_sentence(load(good_case)), "");
    EXPECT_EQ(weight_sentence(load(weighed(""))), "");
    EXPECT_NE(weight_sentence(load(good_case + erode_stage)).find("nothing has weight"), std::string::npos);
    EXPECT_NE(weight_sentence(load(weighed(erode_stage))).find("all other stages are weightless"), std::string::npos);
}

const std::string migrate_stage = "[[study.one.stage]]\nname = \"away\"\ndo = \"migrate\"\n";

TEST(Gravity, IsNeededWhereFinesMigrate) {
    const Diagnostic problem = find_problem(problems_of(good_case + migrate_stage + "gradients = [0.5]\n"), "E207");
    EXPECT_NE(problem.message.find("gives them no weight"), std::string::npos);
    EXPECT_NE(problem.help.find("[gravity]"), std::string::npos);
    const Case c = load(weighed(migrate_stage + "gradients = [0.5]\n"));
    EXPECT_TRUE(last_spec<erosion::MigrateSpec>(c).gravity);
    EXPECT_EQ(resolved_toml(load(resolved_toml(c))), resolved_toml(c));
}

TEST(Gravity, LetsFinesMigrateUnderGradientsAboveZeroAndSoftnessThatIsSmall) {
    for (const std::string wrong :
         {"gradients = [0.2, 0]\n", "gradients = [-0.1]\n", "gradients = [0.1]\nsoftness = 0.1\n",
          "gradients = [0.1]\nexit = \"-1 mm\"\n", "gradients = [0.1]\nhold_at_most = \"0 s\"\n"}) {
        const std::vector<Diagnostic> problems = problems_of(weighed(migrate_stage + wrong));
        ASSERT_FALSE(problems.empty()) << wrong;
        EXPECT_GT(problems.front().line, 0) << wrong;
        EXPECT_FALSE(problems.front().is_warning) << wrong;
    }
    EXPECT_FALSE(problems_of(weighed(migrate_stage)).empty()) << "gradients are required";
}

TEST(Gravity, LetsFinesEnterThatTheSoilHas) {
    const Case c = load(weighed(migrate_stage + "gradients = [0.1]\nfeed = \"0.5 kg/m^3\"\n"));
    EXPECT_DOUBLE_EQ(last_spec<erosion::MigrateSpec>(c).feed.value_or(0), 0.5);
    EXPECT_FALSE(problems_of(weighed(migrate_stage + "gradients = [0.1]\nfeed = \"0 kg/m^3\"\n")).empty());
    const std::string no_soil = "schema = 1\n" + gravity +
                                "[[study.one.stage]]\nname = \"packing\"\ndo = \"import\"\npath = \"packing.csv\"\n"
                                "cell = [\"1 cm\", \"1 cm\", \"1 cm\"]\n" +
                                migrate_stage + "gradients = [0.1]\nfeed = \"0.5 kg/m^3\"\n";
    const std::vector<Diagnostic> problems = problems_of(no_soil);
    EXPECT_TRUE(std::ranges::any_of(problems, [](const Diagnostic& problem) {
        return problem.code == "E605" && problem.message.find("no soil whose fines these are") != std::string::npos;
    })) << render(problems);
}

TEST(Gravity, WarnsOfAFlowThatLiftsTheWholeSoilWhereFinesMigrate) {
    const auto loaded =
        load_case_text(weighed(migrate_stage + "gradients = [0.2, 3]\n"), "case.toml", testing::data_folder());
    EXPECT_NE(find_problem(loaded.warnings, "W604").message.find("heave"), std::string::npos);
}

TEST(Gravity, MayPointAnywhereAndPullAsHardAsOneLikes) {
    const Case c =
        load(replaced(weighed(erode_stage), "down = \"-z\"", "down = [0, 3, -4]\nacceleration = \"981 m/s^2\""));
    EXPECT_NEAR(norm(c.gravity->down - Vec3{0, 0.6, -0.8}), 0, 1e-15);
    EXPECT_EQ(c.gravity->acceleration, 981);
}

TEST(Gravity, NeedsADirection) {
    const Diagnostic missing = find_problem(problems_of(replaced(weighed(""), "down = \"-z\"\n", "")), "E201");
    EXPECT_NE(missing.message.find("`down`"), std::string::npos) << missing.message;
    const Diagnostic none = find_problem(problems_of(replaced(weighed(""), "\"-z\"", "[0, 0, 0]")), "E312");
    EXPECT_NE(none.message.find("`down` has no length"), std::string::npos) << none.message;
}

TEST(Gravity, IsPartOfWhatAProbeDependsOnAndOfNothingElse) {
    const auto dependencies = [](const Case& c, std::size_t stage) {
        const Variant& variant = c.studies.front().variants.front();
        return dependencies_of(c, variant, variant.stages[stage]);
    };
    const Case light = load(good_case + erode_stage), heavy = load(weighed(erode_stage));
    EXPECT_EQ(dependencies(light, 1), dependencies(heavy, 1)); // a compaction
    EXPECT_NE(dependencies(light, 2), dependencies(heavy, 2));
}

TEST(Gravity, WantsGrainsThatSink) {
    for (const char* density : {"900 kg/m^3", "1000 kg/m^3"}) {
        const std::string light = "[grain]\ndensity = \"" + std::string(density) + "\"\n" + gravity;
        const Diagnostic found = find_problem(problems_of(replaced(weighed(""), gravity, light)), "E617");
        EXPECT_NE(found.message.find("do not sink"), std::string::npos) << found.message;
        EXPECT_EQ(found.line, 3);
    }
}

TEST(Gravity, LeavesNoMeaningToKeysOfAProbeWithoutWeight) {
    for (const char* key :
         {"ramp = 100", "watch = 100", "probe_unbalanced_force = 1e-7", "relax_limit = 100",
          "detached = { by = \"displacement\" }"}) {
        for (const std::string& stage : {detach_stage, erode_stage}) {
            EXPECT_EQ(find_problem(problems_of(good_case + stage + key + "\n"), "E207").message.find("no E207"), 0U);
            const Diagnostic found = find_problem(problems_of(weighed(stage + key + "\n")), "E207");
            EXPECT_NE(found.message.find("no meaning where fines have weight"), std::string::npos) << found.message;
            EXPECT_EQ(found.line, 20) << key;
        }
    }
    for (const std::string& stage : {detach_stage, erode_stage}) {
        const Diagnostic loose = find_problem(problems_of(weighed(stage + "hold = \"none\"\n")), "E207");
        EXPECT_NE(loose.message.find("all would fall"), std::string::npos) << loose.message;
        EXPECT_EQ(
            find_problem(problems_of(weighed(stage + "hold = \"coarse\"\n")), "E207").message.find("no E207"), 0U
        );
    }
}

TEST(Gravity, HasKeysOfHowFinesMoveWhichComeBackFromTheResolvedCase) {
    const std::string keys = "hold_at_most = 50\nfluid_drag = 2\nmoved = 0.2\nsoftness = 1e-4\n";
    for (const std::string& stage : {detach_stage, erode_stage}) {
        const Case c = load(weighed(stage + keys)), back = load(resolved_toml(c));
        for (const Case* one : {&c, &back}) {
            const Stage& last = one->studies.front().variants.front().stages.back();
            const auto* detach = std::get_if<erosion::DetachStageSpec>(&last.spec);
            const erosion::WeighedMotion& motion =
                detach ? detach->probe.weighed : std::get<erosion::ErodeSpec>(last.spec).probe.weighed;
            EXPECT_EQ(motion.hold_at_most, 50);
            EXPECT_EQ(motion.fluid_drag, 2);
            EXPECT_EQ(motion.moved, 0.2);
            EXPECT_EQ(motion.softness, 1e-4);
        }
        for (const char* key : {"hold_at_most = 50", "fluid_drag = 2", "moved = 0.2", "softness = 1e-4"}) {
            const Diagnostic found = find_problem(problems_of(good_case + stage + key + "\n"), "E207");
            EXPECT_NE(found.message.find("fines have no weight"), std::string::npos) << found.message;
            EXPECT_EQ(found.line, 18) << key;
        }
        for (const char* key : {"hold_at_most = 3", "fluid_drag = 0", "moved = 0", "softness = 0.05"}) {
            EXPECT_EQ(find_problem(problems_of(weighed(stage + key + "\n")), "E312").line, 20) << key;
        }
    }
}

/// Two curves, of which so much is fine.
std::string mixture(const std::string& fines_content, const std::string& more = "") {
    return replaced(
        replaced(
            weighed(more), "fines = { finer_than = \"0.15 mm\" }",
            "fines = { psd = \"data/silt.csv\" }\nfines_content = " + fines_content
        ),
        "psd = \"data/sand.csv\"", "coarse = { psd = \"data/sand.csv\" }"
    );
}

TEST(Gravity, NeedsFinesAndACoarseSkeleton) {
    for (const std::string& stage : {detach_stage, erode_stage}) {
        const Diagnostic none = find_problem(problems_of(mixture("\"0 %\"", stage)), "E605");
        EXPECT_NE(none.message.find("`fines_content` = 0 % the soil has no fines"), std::string::npos) << none.message;
        EXPECT_EQ(none.line, 7);
        const Diagnostic all = find_problem(problems_of(mixture("1.0", stage)), "E605");
        EXPECT_NE(all.message.find("100 % the soil has no coarse grains"), std::string::npos) << all.message;
        EXPECT_EQ(find_problem(problems_of(mixture("0.2", stage)), "E605").message.find("no E605"), 0U);
    }
    const std::string forced = erode_stage + "forced = { max_contacts = 1 }\n";
    EXPECT_EQ(find_problem(problems_of(mixture("0.0", forced)), "E605").message.find("no E605"), 0U);
}

TEST(Gravity, NeedsThemAtEveryValueOfASweepForWhichTheStageRuns) {
    const std::string sweep = "sweep = { fines_content = [\"0 %\", \"10 %\", \"100 %\"] }\n";
    const std::string swept =
        replaced(mixture("0.2", detach_stage), "particles = 20000\n", "particles = 20000\n" + sweep);
    std::vector<Diagnostic> found = problems_of(swept);
    std::erase_if(found, [](const Diagnostic& d) { return d.code != "E605"; });
    ASSERT_EQ(found.size(), 2U);
    for (const Diagnostic& d : found) {
        EXPECT_EQ(d.line, 11);
    }
    EXPECT_LT(found[0].column, found[1].column) << "each at its own value";
    EXPECT_NE(found[1].message.find("one/fc=100"), std::string::npos) << found[1].message;
    const std::string only = swept + "only = { fines_content = [\"10 %\"] }\n";
    EXPECT_EQ(find_problem(problems_of(only), "E605").message.find("no E605"), 0U);
}

TEST(Gravity, NeedsThemAmongTheGrainsThatAreDrawn) {
    const std::string limit = "finer_than = \"0.15 mm\"";
    for (const char* beyond : {"finer_than = \"0.05 mm\"", "finer_than = \"0.5 mm\""}) {
        for (const char* count : {"particles = 20000", "particles = 2000000"}) {
            const std::string text =
                replaced(replaced(weighed(detach_stage), limit, beyond), "particles = 20000", count);
            EXPECT_NE(find_problem(problems_of(text), "E606").message.find("leaves no fines or no"), std::string::npos);
        }
    }
    const std::string few = replaced(
        replaced(weighed(detach_stage), limit, "finer_than = \"0.3999 mm\" }\ngrading_tolerance = \"50 %\" #"),
        "particles = 20000", "particles = 700"
    );
    const Diagnostic found = find_problem(problems_of(few), "E605");
    EXPECT_NE(found.message.find("700 grains drawn of this soil are fine"), std::string::npos) << found.message;
}

TEST(Gravity, NeedsFinesThatARemovalHasLeft) {
    const std::string removal = "[[study.one.stage]]\nname = \"out\"\ndo = \"remove\"\n";
    const Diagnostic found = find_problem(problems_of(weighed(removal + detach_stage)), "E605");
    EXPECT_NE(found.message.find("\"out\" before it removes all fines"), std::string::npos) << found.message;
    EXPECT_EQ(
        find_problem(problems_of(weighed(removal + "share = 0.5\n" + detach_stage)), "E605").message.find("no E605"), 0U
    );
    const std::string from = detach_stage + "from = \"initial\"\n";
    EXPECT_EQ(find_problem(problems_of(weighed(removal + from)), "E605").message.find("no E605"), 0U);
}

TEST(Gravity, PassesOverWhatAPresetSaysOfProbesWithoutWeight) {
    const std::string preset = "[presets.quick]\nramp = 100\nwatch = 100\nrelax_limit = 10\npasses = 1\n";
    const Case c = load(weighed(erode_stage) + preset, {.preset = "quick"});
    EXPECT_EQ(last_spec<erosion::ErodeSpec>(c).passes, 1);
    EXPECT_EQ(
        last_spec<erosion::ErodeSpec>(load(good_case + erode_stage + preset, {.preset = "quick"})).probe.ramp, 100
    );
    const LoadOptions given{.preset = "quick", .overrides = {"gravity.down=-z"}};
    EXPECT_TRUE(load(good_case + erode_stage + preset, given).gravity);
}

TEST(Gradients, AreAListOrEqualStepsToTheLast) {
    const auto gradients = [](const std::string& text) {
        return last_spec<erosion::DetachStageSpec>(load(text)).gradients;
    };
    EXPECT_EQ(gradients(weighed(detach_stage + "gradients = [0.1, 0.3]\n")), (std::vector<double>{0.1, 0.3}));
    EXPECT_EQ(
        gradients(weighed(detach_stage + "gradients = { up_to = 0.2, steps = 4 }\n")),
        (std::vector<double>{0.05, 0.1, 0.15, 0.2})
    );
    EXPECT_EQ(gradients(weighed(detach_stage)).size(), 24);   // unless said
    EXPECT_EQ(gradients(good_case + detach_stage).size(), 4); // the paper's
    EXPECT_EQ(gradients(good_case + detach_stage + "gradients = { up_to = 1, steps = 2 }\n").size(), 2);
}

TEST(Gradients, RiseWhereFinesHaveWeight) {
    for (const char* list : {"[0, 0.1]", "[0.2, 0.1]", "[0.1, 0.1]"}) {
        const std::string key = "gradients = " + std::string(list) + "\n";
        const Diagnostic found = find_problem(problems_of(weighed(detach_stage + key)), "E207");
        EXPECT_NE(found.message.find("do not rise from above 0"), std::string::npos) << found.message;
        EXPECT_EQ(find_problem(problems_of(good_case + detach_stage + key), "E207").message.find("no E207"), 0U);
    }
}

TEST(Gradients, DoNotBeginWhereTheWholeSoilFloats) {
    const std::string key = "gradients = [1.1, 1.2]\n";
    const Diagnostic up = find_problem(problems_of(weighed(detach_stage + key)), "E618");
    EXPECT_NE(up.message.find("lifts the whole soil"), std::string::npos) << up.message;
    const std::string level = weighed(detach_stage + key + "direction = \"x\"\n");
    EXPECT_EQ(find_problem(problems_of(level), "E618").message.find("no E618"), 0U);
}

TEST(Gradients, ThatTheSoilHasToBearNeedWeight) {
    const std::string specified_key = "asked_gradient = 0.2\n";
    EXPECT_EQ(last_spec<erosion::DetachStageSpec>(load(weighed(detach_stage + specified_key))).specified_gradient, 0.2);
    const Diagnostic found = find_problem(problems_of(good_case + detach_stage + specified_key), "E207");
    EXPECT_NE(found.message.find("no weight"), std::string::npos) << found.message;
}

TEST(Passes, AreAsManyAsTheListsHaveEntries) {
    const auto erode = [](const std::string& keys) {
        return last_spec<erosion::ErodeSpec>(load(good_case + erode_stage + keys));
    };
    const erosion::ErodeSpec stepped =
        erode("gradient = [0.1, 0.2, \"40 %\"]\nhold = [\"coarse\", \"none\", \"none\"]\n");
    EXPECT_EQ(stepped.passes, 3);
    for (const auto& [pass, gradient] : {std::pair{1, 0.1}, {2, 0.2}, {3, 0.4}, {9, 0.4}}) {
        EXPECT_EQ(erosion::at_pass(stepped, pass).gradient, gradient);
        EXPECT_EQ(erosion::at_pass(stepped, pass).probe.hold_coarse, pass == 1);
    }
    EXPECT_TRUE(erosion::changes_after(stepped, 2));
    EXPECT_FALSE(erosion::changes_after(stepped, 3));
    EXPECT_EQ(erode("gradient = 0.1\n").passes, 2);
    EXPECT_EQ(erode("gradient = [0.1, 0.2]\npasses = 5\n").passes, 5);
    const erosion::ErodeSpec rules =
        erode("detached = [{ by = \"displacement\" }, { by = \"velocity\", rule = \"rising\" }]\n");
    EXPECT_EQ(erosion::at_pass(rules, 1).detached.by, erosion::DetachBy::Displacement);
    EXPECT_EQ(erosion::at_pass(rules, 2).detached.rule, erosion::VelocityRule::Rising);
}

TEST(Passes, ComeBackFromTheResolvedCase) {
    for (const char* keys :
         {"gradient = [0.1, 0.2, 0.4]\n", "gradient = 0.1\n", "hold = [\"coarse\", \"none\"]\n",
          "detached = [{ by = \"displacement\" }, { over = 0.3 }]\n"}) {
        const std::string text = resolved_toml(load(good_case + erode_stage + keys));
        EXPECT_EQ(resolved_toml(load(text)), text) << keys;
    }
}

TEST(Passes, OfListsThatDisagreeAreAnErrorAndEntriesWithoutAPassAWarning) {
    const std::string two = "gradient = [0.1, 0.2]\n";
    const Diagnostic disagree =
        find_problem(problems_of(good_case + erode_stage + two + "hold = [\"coarse\", \"none\", \"none\"]\n"), "E207");
    EXPECT_NE(disagree.message.find("2 passes and for 3"), std::string::npos) << disagree.message;
    const Diagnostic unused = find_problem(problems_of(good_case + erode_stage + two + "passes = 1\n"), "W614");
    EXPECT_NE(unused.message.find("entries for 2 passes, and makes 1"), std::string::npos) << unused.message;
    const Diagnostic empty = find_problem(problems_of(good_case + erode_stage + "gradient = []\n"), "E205");
    EXPECT_NE(empty.message.find("empty list"), std::string::npos) << empty.message;
}

} // namespace
} // namespace suffuse::casefile
