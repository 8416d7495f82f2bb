#include "suffuse/plan/bench_step.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/plan/bench_flow.hpp"
#include "suffuse/plan/bench_scaling.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include <algorithm>

namespace suffuse::plan {
namespace {

const std::string reference = test::in_checkout("tests/reference/");

BenchPacking packing500() {
    // Edges as in packing500.json.
    return {
        reference + "packing500.csv.gz", diagonal({1.4360856339985508e-3, 1.4358137235332051e-3, 1.436026846625529e-3}),
        1};
}

BenchStepResult shear(int threads, int replicate) {
    const int before = thread_count();
    set_thread_count(threads);
    BenchStepSpec spec;
    spec.packing = packing500();
    spec.packing.replicate = replicate;
    spec.steps = 200;
    const BenchStepResult result = bench_step(spec);
    set_thread_count(before);
    return result;
}

TEST(BenchStep, SaysTheSpeedWithThePhysicsItWasReachedAt) {
    const BenchStepResult r = shear(1, 1);
    EXPECT_EQ(r.grains, 500);
    EXPECT_DOUBLE_EQ(r.particle_steps_per_second, r.steps_per_second * 500);
    EXPECT_NEAR(r.ns_per_contact * r.contact_steps_per_second, 1e9, 1);
    EXPECT_GE(r.candidates_per_contact, 1);
    // Settled at 100 kPa within 0.5 %, then sheared by 10 1/s x 200 x 4.1e-8 s = 8e-5: the lateral stress is held, the
    // axial one has begun to rise.
    EXPECT_NEAR(r.stress(0, 0), 100e3, 5e3);
    EXPECT_NEAR(r.stress(1, 1), 100e3, 5e3);
    EXPECT_GT(r.stress(2, 2), r.stress(0, 0));
    EXPECT_NEAR(r.void_ratio, 0.674, 0.005); // of the packing as it came; settling barely changes it
    EXPECT_GT(r.coordination, 2.5);
}

TEST(BenchPacking, IsMadeOfTheExamplesSandWhereNoneIsGiven) {
    const dem::World made = load_bench_packing({});
    EXPECT_EQ(made.grains.size(), 10'000);
    EXPECT_NEAR(*std::max_element(made.grains.radius.begin(), made.grains.radius.end()), 0.2e-3, 0.02e-3);
    double solid = 0;
    for (const double radius : made.grains.radius) {
        solid += sphere_volume(radius);
    }
    EXPECT_NEAR(cell::volume(made.cell) / solid - 1, 0.69, 0.03); // void ratio of a medium dense sand
    const dem::World again = load_bench_packing({});
    EXPECT_TRUE(made.grains.position[123] == again.grains.position[123]);
}

TEST(BenchStep, EndsInTheSameStateForAnyNumberOfThreads) {
    EXPECT_EQ(shear(1, 1).state_hash, shear(2, 1).state_hash);
}

TEST(BenchStep, CopiesOfAPackingHaveItsDensity) {
    const BenchStepResult one = shear(2, 1), eight = shear(2, 2);
    EXPECT_EQ(eight.grains, 8 * one.grains);
    EXPECT_NEAR(eight.void_ratio, one.void_ratio, 1e-4); // the servo ends within its tolerance, not on a point
    EXPECT_NEAR(eight.coordination, one.coordination, 0.1);
}

TEST(BenchStep, ACellThatIsNotThePackingsIsRefused) {
    BenchStepSpec spec;
    spec.packing = packing500();
    spec.packing.cell = 0.8 * spec.packing.cell;
    EXPECT_THROW(bench_step(spec), CaseError);
}

TEST(BenchFlow, FindsTheReferencesPermeability) {
    BenchFlowSpec spec;
    spec.packing = packing500();
    spec.conductance = flow::Conductance::Yade;
    const BenchFlowResult r = bench_flow(spec);
    EXPECT_NEAR(r.permeability, 5.315e-11, 5e-14); // Yade's for this packing, to the digits that it is printed with
    EXPECT_EQ(r.pores, 3045U);
    EXPECT_LE(r.triangulate + r.conductance + r.set_up + r.solve + r.forces, r.total);
    EXPECT_GT(r.triangulate, 0);
    EXPECT_GT(r.iterations, 1);
    EXPECT_GT(r.peak_bytes_per_grain, 100);
}

TEST(BenchScaling, NamesTheShareOfEachPhaseThatStaysWithOneThread) {
    BenchScalingSpec spec;
    spec.packing = packing500();
    spec.packing.replicate = 2;
    spec.steps = 300; // with some contact tables among them
    const BenchScalingResult result = bench_scaling(spec);
    std::vector<std::string> names;
    for (const ScalingWork* const work : {&result.step, &result.flow}) {
        double seconds = 0;
        for (const ScalingPhase& phase : work->phases) {
            names.push_back(phase.name);
            EXPECT_GE(phase.serial_share, 0) << phase.name;
            EXPECT_LE(phase.serial_share, 1) << phase.name;
            EXPECT_GT(phase.speed_up.at(8), 0) << phase.name;
            seconds += phase.seconds;
        }
        EXPECT_NEAR(seconds, work->all.seconds, 1e-9 * seconds);
        EXPECT_GT(work->all.serial_share, 0);
        EXPECT_GT(work->all.loops, 0);
    }
    for (const char* const name : {"step", "contact table", "triangulation", "solution"}) {
        EXPECT_TRUE(std::ranges::count(names, name) == 1) << name;
    }
}

} // namespace
} // namespace suffuse::plan
