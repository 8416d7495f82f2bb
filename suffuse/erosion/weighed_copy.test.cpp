#include "suffuse/erosion/weighed_copy.hpp"

#include "suffuse/contact/stress.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace suffuse::erosion {
namespace {

constexpr double radius = 0.5e-3; // [m]

/// A fine grain on a coarse one of its size, which their contact presses by the given forces over its weight.
dem::World one_on_another(double push, double shear) {
    dem::World world;
    world.cell.h = diagonal({10 * radius, 10 * radius, 10 * radius});
    const grains::Material& material = world.material;
    const double stiffness = contact::normal_stiffness(material, radius, radius, 0);
    add_grain(world.grains, {5 * radius, 5 * radius, 3 * radius}, radius, material.density);
    add_grain(world.grains, {5 * radius, 5 * radius, 5 * radius}, radius, material.density);
    world.grains.fine = {0, 1};
    const double weight = norm(buoyant_weights(world, {}, {}).back());
    world.grains.position.back().z -= push * weight / stiffness;
    dem::StepCaches caches;
    dem::step(world, caches, {.dt = 1e-12}); // finds the contact
    world.contacts.shear_force.set(0, {shear * weight, 0, 0});
    return world;
}

TEST(WeighedCopy, HoldsFinesThatAContactPressesWithMoreThanAHundredTimesTheirWeight) {
    struct Pressed {
        double push, shear;
        bool is_held;
    };

    const std::vector<Pressed> all = {{99, 0, false}, {101, 0, true}, {60, 79, false}, {60, 81, true}};
    for (const Pressed& each : all) {
        const dem::World world = one_on_another(each.push, each.shear);
        ASSERT_EQ(world.contacts.size(), 1U);
        const WeighedCopy copy(world, buoyant_weights(world, {}, {}), {});
        EXPECT_EQ(copy.bears_load(0), each.is_held) << each.push << ", " << each.shear;
        EXPECT_EQ(copy.free_count(), each.is_held ? 0 : 1);
    }
}

TEST(WeighedCopy, TakesStepsThatDoNotDependOnTheMassOfHeldGrains) {
    std::vector<double> time_step;
    for (const double lighter : {1.0, 0.01}) {
        dem::World world = one_on_another(1, 0);
        world.grains.mass.front() *= lighter;
        world.grains.inertia.front() *= lighter;
        WeighedCopy copy(world, buoyant_weights(world, {}, {}), {});
        copy.hold(1e-3, {}, 0, {}, "rest");
        time_step.push_back(copy.time_step());
    }
    EXPECT_GT(time_step[1], 0);
    EXPECT_NEAR(time_step[1] / time_step[0], 1, 1e-3); // a held grain is a million times as heavy as it is
}

} // namespace
} // namespace suffuse::erosion
