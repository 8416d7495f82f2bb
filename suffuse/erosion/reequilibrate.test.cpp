// A new equilibrium from which nothing was taken is the old one: closed forms of what the two phases hold.

#include "suffuse/erosion/reequilibrate.hpp"

#include "suffuse/dem/inspect.hpp"
#include "suffuse/erosion/extraction.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::erosion {
namespace {

class NewEquilibrium : public testing::Test {
protected:
    NewEquilibrium() : world(test::reference_packing("packing500")) {
        around.balance = {1e-2, 50};
        before.initial_mass = total_mass(world.grains);
    }

    dem::World world;
    Surroundings around;
    ErosionResult before;
    PassResult pass;
};

TEST(Adrift, IsASkeletonWithoutATenthOfItsStressForFourHundredThousandSteps) {
    constexpr double held = 1e5;
    const auto after = [](double share, std::int64_t steps) {
        Resettlement so_far;
        so_far.last_carrying = 1000;
        so_far.balance.steps = 1000 + steps;
        so_far.balance.stress = diagonal({share * held, share * held, share * held});
        return is_adrift(held, so_far);
    };
    EXPECT_FALSE(after(0.099, 399'950));
    EXPECT_TRUE(after(0.099, 400'000));
    EXPECT_FALSE(after(0.101, 400'000));
}

TEST_F(NewEquilibrium, DescribesWhatThePassStartsFrom) {
    describe_before(world, pass);
    EXPECT_EQ(pass.stress_before, dem::mean_stress_tensor(world));
    EXPECT_EQ(pass.porosity_before, dem::porosity(world));
}

TEST_F(NewEquilibrium, KeepsTheVolumeFirstAndThenTheStress) {
    dem::StepCaches caches;
    dem::step(world, caches, test::plan_of(1e-9)); // its contacts are found, and nothing has moved
    describe_before(world, pass);
    const double pressure = dem::mean_stress(pass.stress_before);
    ASSERT_GT(pressure, 0);
    Resettlement so_far;
    reequilibrate(world, {}, before, around, pass, so_far);
    const std::vector<PathRow>& path = so_far.rows;
    EXPECT_FALSE(pass.failed);
    EXPECT_EQ(pass.porosity_after_removal, pass.porosity_before) << "nothing left, and the cell stands still";
    EXPECT_NEAR(dem::mean_stress(pass.stress_after_removal), pressure, 1e-3 * pressure) << "nor has a step moved much";
    EXPECT_NEAR(
        dem::mean_stress(pass.stress_after), pressure, 0.02 * pressure
    ); // the balance requires 1 %, on each axis
    bool held_still = true;
    for (const PathRow& row : path) {
        held_still = held_still && (row.phase == Phase::Servo || row.volumetric_strain == 0);
        EXPECT_EQ(row.eroded_mass, 0);
    }
    EXPECT_TRUE(held_still);
    EXPECT_EQ(path.front().phase, Phase::Removal);
    EXPECT_EQ(path.back().phase, Phase::Servo);
    EXPECT_EQ(path.back().step, pass.steps);
}

TEST_F(NewEquilibrium, OfASkeletonThatMayNotStrainHasFailed) {
    dem::StepCaches caches;
    dem::step(world, caches, test::plan_of(1e-9)); // its contacts are found: there is a stress to come back to
    describe_before(world, pass);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.radius[g] *= 0.99; // nothing touches any more: the servo closes the cell by about a hundredth
    }
    world.contacts = {};
    ResettleSpec spec;
    spec.max_strain = 1e-4;
    Resettlement so_far;
    reequilibrate(world, spec, before, around, pass, so_far);
    EXPECT_TRUE(pass.failed);
    ASSERT_TRUE(std::holds_alternative<SkeletonFailed>(pass.verdict.why));
}

} // namespace
} // namespace suffuse::erosion
