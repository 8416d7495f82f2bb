// Closed forms of a price; whole stages are held to recorded runs by planned_runs.test.cpp.

#include "suffuse/plan/price_stage.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace suffuse::plan {
namespace {

TEST(StagePrice, OfAStrainFollowsFromTheVolumeOfTheSolid) {
    // (1 - n) V stays: from n = 0.6 to 0.4 the volume falls to 2/3, and each of three axes by a third of its logarithm.
    EXPECT_DOUBLE_EQ(strain_between(0.6, 0.4), std::log(1.5) / 3);
    EXPECT_EQ(strain_between(0.4, 0.4), 0);
    EXPECT_EQ(strain_between(0.4, 0.5), 0) << "loosening takes no strain";
    EXPECT_GT(strain_between(0.4001, 0.4), 10 * std::log(1.0001) / 3) << "a little is strained at least";
}

TEST(StagePrice, OfWaitingIsThePatienceOfTheCase) {
    casefile::Case what;
    what.balance.patience = 1000;
    const Range steps = waited(what, {200, 400});
    EXPECT_EQ(steps.least, 1200);
    EXPECT_DOUBLE_EQ(steps.most, 1600);
}

TEST(StagePrice, InSecondsIsStepsTimesWorkOverSpeedPlusExtras) {
    StagePrice price;
    price.steps = {1000, 1000};
    price.work = {500, 500};
    const MachineSpeed machine{1e6, 500, 1};
    const Range stepping = seconds_of(price, machine); // 0.5 s, give or take the error of a price
    EXPECT_LT(stepping.least, 0.5);
    EXPECT_GT(stepping.most, 0.5);
    EXPECT_DOUBLE_EQ(seconds_of(price, {2e6, 500, 1}).most, stepping.most / 2);
    price.seconds = {3, 4};
    EXPECT_DOUBLE_EQ(seconds_of(price, machine).least, stepping.least + 3);
    EXPECT_DOUBLE_EQ(seconds_of(price, machine).most, stepping.most + 4);
}

TEST(StagePrice, OfStepsInReferenceModeGoesByThatSpeed) {
    StagePrice price;
    price.reference_steps = {1000, 1000};
    price.work = {500, 500};
    MachineSpeed machine{1e6, 500, 1};
    const double as_fast = seconds_of(price, machine).most;
    machine.in_reference_mode = 0.25e6;
    EXPECT_DOUBLE_EQ(seconds_of(price, machine).most, 4 * as_fast);
}

/// Steps of fines that migrate for a second.
double steps_a_second(const std::vector<double>& radii) {
    casefile::Stage stage;
    const auto most_of = [&](double time_at_most) {
        erosion::MigrateSpec spec;
        spec.gradients = {1};
        spec.hold_at_most = 10;
        spec.time_at_most = time_at_most;
        stage.spec = spec;
        grains::Grains grains;
        for (const double radius : radii) {
            grains.fine[add_grain(grains, {}, radius, 2650)] = 1;
        }
        PricedSample sample = describe(grains);
        return price_stage({}, {}, stage, sample).reference_steps.most;
    };
    return most_of(3) - most_of(2);
}

TEST(StagePrice, OfFinesThatMigrateFollowsTheirLargestAndTheirSmallest) {
    // Contacts are as stiff as the weight of the largest asks for: steps go as the root of d_max, and as 1/d_min.
    const double equal = steps_a_second({5e-5, 5e-5});
    EXPECT_NEAR(steps_a_second({5e-5, 2e-4}), 2 * equal, 1e-9 * equal);
    EXPECT_NEAR(steps_a_second({1.25e-5, 5e-5}), 4 * equal, 1e-9 * equal);
}

/// Memory of a resolved flow beyond that of the network, in boxes of 150 bytes.
double boxes_of_flow(int boxes_across, bool tensor) {
    const auto memory = [&](flow::Solver solver) {
        flow::FlowSpec spec;
        spec.tensor = tensor;
        spec.how.solver = solver;
        if (solver == flow::Solver::Resolved) {
            spec.how.resolve = boxes_across;
        }
        casefile::Stage stage;
        stage.spec = spec;
        grains::Grains grains;
        for (int g = 0; g < 8; ++g) {
            add_grain(grains, {}, 5e-5, 2650);
        }
        PricedSample sample = describe(grains);
        sample.solid_fraction = pi / 6; // a cell of two diameters
        casefile::Variant variant;
        variant.material.density = 2650;
        return price_stage({}, variant, stage, sample).memory_a_grain * 8;
    };
    return (memory(flow::Solver::Resolved) - memory(flow::Solver::Network)) / 150;
}

TEST(StagePrice, OfAResolvedFlowIsOfAGridThatItCanTransform) {
    EXPECT_NEAR(boxes_of_flow(12, false), 24 * 24 * 24, 1e-6); // 24 = 2 2 2 3
    EXPECT_NEAR(boxes_of_flow(11, false), 24 * 24 * 24, 1e-6) << "22 has the factor 11";
    EXPECT_GT(boxes_of_flow(12, true), boxes_of_flow(12, false)) << "two directions are kept for the third";
}

} // namespace
} // namespace suffuse::plan
