#include "suffuse/plan/plan.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/job/run_case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <cmath>
#include <map>

namespace suffuse::job {
namespace {

const plan::MachineSpeed a_machine{1e7, 10'000, 2};

/// The replay example's packing at 100 kPa, with one more stage.
casefile::Case replay_and(const std::string& stage) {
    const std::string text = R"(
schema = 1
[study.replay]
[[study.replay.stage]]
name = "start"
do = "import"
packing = "packing.csv"
cell = ["1.4360856339985508 mm", "1.4358137235332051 mm", "1.436026846625529 mm"]
[[study.replay.stage]]
name = "settled"
do = "settle"
pressure = "100 kPa"
[[study.replay.stage]]
name = "last"
)" + stage;
    return casefile::load_case_text(text, "case.toml", test::in_checkout("examples/replay")).value;
}

plan::RunPlan plan_of(const std::string& stage) {
    return plan::plan_run(replay_and(stage), a_machine);
}

casefile::Case fontainebleau(const std::vector<std::string>& overrides) {
    return casefile::load_case(test::in_checkout("examples/fontainebleau-2016/case.toml"), {"standard", overrides})
        .value;
}

const plan::StageEstimate& stage_named(const plan::RunPlan& plan, const std::string& name) {
    for (const plan::StageEstimate& stage : plan.stages) {
        if (stage.stage == name) {
            return stage;
        }
    }
    throw Bug("no stage " + name);
}

TEST(Plan, AFixedNumberOfStepsIsExact) {
    const plan::StageEstimate last = plan_of(R"(do = "advance"
steps = 1234
time_step = "4.1e-8 s"
strain_rate = ["10 1/s", "0 1/s", "0 1/s"])")
                                         .stages.back();
    EXPECT_EQ(last.steps.least, 1234);
    EXPECT_EQ(last.steps.most, 1234);
    EXPECT_EQ(last.grains, 500);
}

TEST(Plan, AStrainDrivenTestWithAGivenTimeStepIsExact) {
    const auto plan = [](const std::string& strain, const std::string& number, const std::string& dt) {
        return plan_of(fmt::format(
                           "do = \"triaxial\"\nstrain = \"{} %\"\ninertial_number = {}\ntime_step = \"{} s\"", strain,
                           number, dt
                       ))
            .stages.back()
            .steps;
    };
    const Range steps = plan("4", "1e-3", "4e-8");
    EXPECT_EQ(steps.least, steps.most);
    // rate = I sqrt(p/rho)/d50 with p = 100 kPa, rho = 2600 kg/m3 and d50 = 0.21 mm within a tenth, as of this sand
    const double expected = 0.04 * 0.21e-3 / (1e-3 * std::sqrt(100e3 / 2600) * 4e-8);
    EXPECT_NEAR(steps.least, expected, 0.1 * expected);
    EXPECT_NEAR(plan("8", "1e-3", "4e-8").least, 2 * steps.least, 1e-9 * steps.least); // rounding only
    EXPECT_NEAR(plan("4", "1e-4", "4e-8").least, 10 * steps.least, 1e-9 * steps.least);
    EXPECT_NEAR(plan("4", "1e-3", "2e-8").least, 2 * steps.least, 1e-9 * steps.least);
}

TEST(Plan, AProbeIsPaidForEachGradientOrPassAndOnceMoreForItsTwin) {
    const auto steps = [](const std::string& stage, const std::vector<std::string>& overrides) {
        return stage_named(plan::plan_run(fontainebleau(overrides), a_machine), stage).steps;
    };
    const Range probe = steps("probe", {}), longer = steps("probe", {"study.erosion.stage.probe.watch=2000"});
    EXPECT_EQ(longer.least - probe.least, (4 + 1) * 1000); // four gradients share a twin
    const Range erosion = steps("erosion", {}), slower = steps("erosion", {"study.erosion.stage.erosion.watch=2000"});
    EXPECT_EQ(slower.most - erosion.most, 2 * 2 * 1000); // two passes
}

TEST(Plan, ACompactionPaysForItsProtocolAndForTheSearchOfADensity) {
    const auto steps = [](const std::vector<std::string>& overrides) {
        return stage_named(plan::plan_run(fontainebleau(overrides), a_machine), "initial").steps;
    };
    const std::string initial = "study.erosion.stage.initial.";
    const Range faithful = steps({});
    const Range swift = steps({initial + "protocol=swift"}); // up to 9,600: frictionless grains creep
    EXPECT_LT(std::sqrt(swift.least * swift.most), faithful.least);
    EXPECT_GT(steps({initial + "void_ratio=0.68"}).least, 1.5 * faithful.least); // at least both ends of the scale
    EXPECT_GT(
        steps({initial + "prepare.adhesion={normal=\"1 MPa\", shear=\"1 MPa\"}"}).least, faithful.least
    ); // its gas
    // Sixteen dense seeds (validation/slow_seeds.csv) took 40,700 to 54,850 steps.
    const Range slow = steps({initial + "protocol=slow"});
    EXPECT_LT(slow.least, 40'700);
    EXPECT_GT(slow.most, 54'850);
}

TEST(Plan, WithoutFrictionASampleCreepsTheLongerTheMoreMedianGrainsWideItIs) {
    const auto steps = [](const std::string& fines_content) {
        const casefile::Case what =
            casefile::load_case(
                test::in_checkout("examples/silty-sand-2016/as-it-falls.toml"),
                {"standard", {"study.fines.sweep.fines_content=[\"" + fines_content + "\"]"}, {"fines"}}
            ).value;
        return stage_named(plan::plan_run(what, a_machine), "dense").steps;
    };
    // Seeds of the study took 250,000 to 410,000 steps at 80 % (34,500 grains), 20,400 at 30 %, of coarse median.
    const Range many = steps("80 %"), few = steps("30 %");
    EXPECT_LT(many.least, 250'000);
    EXPECT_GT(many.most, 410'000);
    EXPECT_LT(few.least, 20'400);
    EXPECT_GT(few.most, 20'400);
    EXPECT_LT(few.most, 100'000);
}

TEST(Plan, SamplesThatRefineAddsAreCountedFromTheCheapestToTheDearest) {
    const auto plan = [](const std::string& refine) {
        std::vector<std::string> overrides{"study.fines.replicates=2"};
        if (!refine.empty()) {
            overrides.push_back("study.fines.refine=" + refine);
        }
        const std::string file = test::in_checkout("examples/silty-sand-2016/as-it-falls.toml");
        return plan::plan_run(casefile::load_case(file, {"quick", overrides, {"fines"}}).value, a_machine);
    };
    const plan::RunPlan listed = plan("");
    const plan::RunPlan refined =
        plan(R"({key="fines_content", around="minimum", of="void_ratio", at=["loose","dense"], add=1})");
    EXPECT_EQ(listed.refined.samples.most, 0);
    EXPECT_EQ(refined.refined.samples.least, 1 * 2);    // one side of an extreme that both curves share
    EXPECT_EQ(refined.refined.samples.most, 2 * 2 * 2); // both sides of an extreme of each curve
    EXPECT_GT(refined.refined.seconds.least, 0);
    EXPECT_LT(refined.refined.seconds.least, refined.refined.seconds.most);
    EXPECT_GT(refined.seconds.least, listed.seconds.least);
    EXPECT_NEAR(refined.seconds.most, listed.seconds.most + 8 * refined.refined.seconds.most, 1e-9);
}

TEST(Plan, AStressIsReachedInAStrainThatGrowsWithIt) {
    const auto steps = [](const std::string& ratio) {
        return stage_named(
                   plan::plan_run(
                       fontainebleau(
                           {"study.erosion.stage.deviatoric.stress_ratio=" + ratio,
                            "study.erosion.stage.deviatoric.inertia=own"}
                       ),
                       a_machine
                   ),
                   "deviatoric"
        )
            .steps;
    };
    EXPECT_GT(steps("0.9").least, steps("0.3").least);
    // Samples of 10,000 grains with their own inertia took 1,700 steps to q/p = 0.25 and 4,000 to 1.0
    // (examples/second-erosion).
    EXPECT_LT(steps("0.25").least, 1'700);
    EXPECT_GT(steps("0.25").most, 1'700);
    EXPECT_LT(steps("1.0").least, 4'000);
    EXPECT_GT(steps("1.0").most, 4'000);
}

TEST(Plan, ItsSumsAreThoseOfItsStages) {
    const plan::RunPlan plan = plan::plan_run(fontainebleau({}), a_machine);
    Range steps, seconds;
    for (const plan::StageEstimate& stage : plan.stages) {
        EXPECT_LE(stage.steps.least, stage.steps.most) << stage.stage;
        EXPECT_LE(stage.seconds.least, stage.seconds.most) << stage.stage;
        steps += stage.steps;
        seconds += stage.seconds;
        EXPECT_LE(stage.memory, plan.memory) << stage.stage;
    }
    EXPECT_GT(plan.steps.least, steps.least); // not all stages err to one side
    EXPECT_LT(plan.steps.most, steps.most);
    EXPECT_GT(plan.seconds.least, seconds.least);
    EXPECT_LT(plan.seconds.most, seconds.most);
    EXPECT_GT(plan.seconds.most, 1.3 * plan.seconds.least); // the machine's error is common to all
}

TEST(Plan, AMachineTwiceAsFastStepsInHalfTheTime) {
    const casefile::Case what = replay_and("do = \"settle\"\npressure = \"200 kPa\"");
    const plan::StageEstimate slow = plan::plan_run(what, a_machine).stages.back();
    const plan::StageEstimate fast = plan::plan_run(what, {2e7, 10'000, 2}).stages.back();
    EXPECT_DOUBLE_EQ(fast.seconds.most, slow.seconds.most / 2);
    EXPECT_EQ(fast.steps.most, slow.steps.most);
}

TEST(Plan, ARunOfTheReplayLiesWithinItsRanges) {
    const casefile::Case what = casefile::load_case(test::in_checkout("examples/replay/case.toml")).value;
    const plan::RunPlan plan = plan::plan_run(what, a_machine);
    const test::TempFolder folder;
    std::map<std::string, long long> steps;
    run::RunOptions options;
    options.folder = folder / "run";
    options.on_progress = [&](const run::Progress& progress) {
        if (progress.stage_finished) {
            steps[progress.stage] = progress.state.value("steps", 0LL);
        }
    };
    run_case(what, options);
    for (const std::string stage : {"settled", "compressed"}) {
        EXPECT_GE(static_cast<double>(steps[stage]), stage_named(plan, stage).steps.least) << stage;
        EXPECT_LE(static_cast<double>(steps[stage]), stage_named(plan, stage).steps.most) << stage;
    }
}

TEST(Plan, ALargeSampleIsPricedFromSomeOfItsGrains) {
    const auto plan_of_grains = [](const std::string& particles) {
        const std::string text = R"(
schema = 1
[soil.mixture]
coarse        = { psd = { d = ["0.8 mm", "1.2 mm"], passing = ["0 %", "100 %"] } }
fines         = { psd = { d = ["0.15 mm", "0.25 mm"], passing = ["0 %", "100 %"] } }
fines_content = "20 %"
[study.s]
soil      = "mixture"
particles = )" + particles + R"(
[[study.s.stage]]
name = "cloud"
do   = "pack"
[[study.s.stage]]
name     = "initial"
do       = "compact"
pressure = "100 kPa"
protocol = "swift"
)";
        return plan::plan_run(casefile::load_case_text(text, "case.toml", ".").value, a_machine);
    };
    constexpr double more = 10'000, little = 0.02; // the largest and smallest of more grains are a bit further apart
    const plan::RunPlan small = plan_of_grains("200000"), large = plan_of_grains("2000000000");
    for (const std::string name : {"cloud", "initial"}) {
        const plan::StageEstimate &few = stage_named(small, name), &many = stage_named(large, name);
        EXPECT_EQ(many.grains, 2'000'000'000);
        EXPECT_NEAR(many.memory, more * few.memory, little * many.memory) << name;
        EXPECT_NEAR(many.steps.most, few.steps.most, little * few.steps.most) << name;
        EXPECT_NEAR(many.seconds.most, more * few.seconds.most, little * many.seconds.most) << name;
    }
    const plan::StageEstimate &few = stage_named(small, "cloud"), &many = stage_named(large, "cloud");
    EXPECT_NEAR(static_cast<double>(many.coarse), more * static_cast<double>(few.coarse), little * more * 1e4);
    EXPECT_NEAR(*many.fines_content, *few.fines_content, little * *few.fines_content);
}

TEST(Plan, ALargeMixtureHasItsFinesContentThoughFewOfItsCoarseGrainsAreDrawn) {
    const std::string text = R"(
schema = 1
[soil.mixture]
coarse        = { psd = { d = ["10 mm", "12 mm"], passing = ["0 %", "100 %"] } }
fines         = { psd = { d = ["0.15 mm", "0.25 mm"], passing = ["0 %", "100 %"] } }
fines_content = "20 %"
[study.s]
soil      = "mixture"
particles = 1000000000
[[study.s.stage]]
name = "cloud"
do   = "pack"
)";
    const plan::RunPlan plan = plan::plan_run(casefile::load_case_text(text, "case.toml", ".").value, a_machine);
    EXPECT_EQ(plan.stages.at(0).grains, 1'000'000'000);
    EXPECT_NEAR(plan.stages.at(0).fines_content.value(), 0.2, 1e-5); // between grains the mass is met exactly
}

TEST(Plan, ASampleOfFinesAloneThatIsToLoseThemCostsNothingMore) {
    const std::string text = R"(
schema = 1
[soil.mixture]
coarse            = { psd = { d = ["0.28 mm", "0.32 mm"], passing = ["0 %", "100 %"] } }
fines             = { psd = { d = ["0.14 mm", "0.16 mm"], passing = ["0 %", "100 %"] } }
fines_content     = "100 %"
grading_tolerance = "10 %"
[study.s]
soil = "mixture"
particles = 400
[[study.s.stage]]
name = "cloud"
do = "pack"
[[study.s.stage]]
name = "initial"
do = "compact"
pressure = "100 kPa"
[[study.s.stage]]
name = "removed"
do = "remove"
)";
    const plan::RunPlan plan = plan::plan_run(casefile::load_case_text(text, "case.toml", ".").value, a_machine);
    EXPECT_EQ(stage_named(plan, "removed").steps.most, 0);
    EXPECT_EQ(stage_named(plan, "removed").grains, 400);
    EXPECT_TRUE(std::isfinite(plan.seconds.most)) << plan.seconds.most;
    EXPECT_TRUE(std::isfinite(plan.memory)) << plan.memory;
}

TEST(Plan, AMissingPackingIsNamed) {
    casefile::Case what = replay_and("do = \"settle\"\npressure = \"200 kPa\"");
    std::get<casefile::ImportSpec>(what.studies[0].variants[0].stages[0].spec).path = "/nowhere/packing.csv";
    try {
        plan::plan_run(what, a_machine);
        FAIL() << "a packing that is not there was read";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/packing.csv"), std::string::npos);
    }
}

} // namespace
} // namespace suffuse::job
