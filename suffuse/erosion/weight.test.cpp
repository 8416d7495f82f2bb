#include "suffuse/erosion/weight.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::erosion {
namespace {

dem::World some_grains() {
    dem::World world;
    world.cell.h = diagonal({4e-3, 3e-3, 2e-3});
    for (const double r : {0.5e-3, 0.4e-3, 0.1e-3, 0.03e-3}) {
        add_grain(world.grains, {1e-3 + 2 * r, 1e-3, 1e-3}, r, world.material.density);
    }
    world.grains.fine = {0, 0, 1, 1};
    return world;
}

TEST(Weight, AddsUpToTheSubmergedWeightOfTheCell) {
    const dem::World world = some_grains();
    const Gravity gravity{.down = {0.6, 0, -0.8}, .acceleration = 9.81};
    const flow::Fluid fluid{.density = 998};
    Vec3 sum;
    for (const Vec3& weight : buoyant_weights(world, gravity, fluid)) {
        sum += weight;
    }
    const double solid = (1 - dem::porosity(world)) * cell::volume(world.cell);
    const Vec3 whole = (solid * (world.material.density - 998) * 9.81) * gravity.down;
    EXPECT_NEAR(norm(sum - whole), 0, 1e-14 * norm(whole)); // rounding of four terms
}

TEST(Weight, OfGrainsThatDoNotSinkIsAnErrorThatNamesBothDensities) {
    const dem::World world = some_grains();
    for (const double density : {world.material.density, 2 * world.material.density}) {
        try {
            (void)buoyant_weights(world, {}, {.density = density});
            FAIL() << "grains of " << world.material.density << " in " << density;
        } catch (const CaseError& error) {
            EXPECT_NE(std::string(error.what()).find("leave [gravity] out"), std::string::npos) << error.what();
        }
    }
}

TEST(Weight, IsCarriedByTerzaghisGradientWhichIsAlsoGsLessOneOverOnePlusE) {
    const double porosity = 0.4, void_ratio = porosity / (1 - porosity);
    EXPECT_NEAR(critical_gradient(porosity, 2650, 1000), (2.65 - 1) / (1 + void_ratio), 1e-15);
}

TEST(Weight, IsLiftedByTheUpwardPartOfAFlowAndByNoOther) {
    const Gravity gravity{.down = {0, 0, -1}};
    EXPECT_EQ(heave_gradient(0.9, gravity, {0, 0, 2}), 0.9);
    EXPECT_NEAR(*heave_gradient(0.9, gravity, {1, 0, 1}), 0.9 * std::sqrt(2.0), 1e-15);
    EXPECT_FALSE(heave_gradient(0.9, gravity, {1, 0, 0}));
    EXPECT_FALSE(heave_gradient(0.9, gravity, {0, 0, -1}));
}

TEST(Weight, IsScaledUntilItPressesTheLargestFinesIntoEachOtherAsFarAsSpecified) {
    dem::World world = some_grains();
    for (const grains::ContactLaw law : {grains::ContactLaw::LinearRolling, grains::ContactLaw::HertzMindlin}) {
        world.material.law = law;
        const std::vector<Vec3> weight = buoyant_weights(world, {}, {});
        const std::vector<std::uint32_t> fines = {2, 3};
        const WeightScale scale = scale_weight(world, weight, fines);
        const double r = world.grains.radius[2], push = scale.factor * norm(weight[2]);
        // Half the overlap gives half the force, or the power of it that the law has.
        const double stiffness = contact::normal_stiffness(world.material, r, r, 1e-3 * r);
        const double exponent = law == grains::ContactLaw::LinearRolling ? 1 : 1.5;
        EXPECT_NEAR(push, stiffness * 1e-3 * r / exponent, 1e-12 * push);
        const double d = 2 * world.grains.radius[2]; // the upper of two is the median
        EXPECT_NEAR(0.5 * scale.acceleration * scale.time * scale.time, d / 2, 1e-12 * d);
        const WeightScale stiffer = scale_weight(world, weight, fines, {.fluid_drag = 3, .softness = 1e-4});
        EXPECT_NEAR(stiffer.factor, std::pow(0.1, exponent) * scale.factor, 1e-12 * scale.factor);
        EXPECT_NEAR(stiffer.drag * stiffer.time, 3 * scale.drag * scale.time, 1e-12);
        EXPECT_NEAR(scale.acceleration / scale.drag, std::sqrt(scale.acceleration * d / 2), 1e-12);
    }
}

} // namespace
} // namespace suffuse::erosion
