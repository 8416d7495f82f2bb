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

TEST(WeighedCopy, GivesBackTheContactsOfItsSkeletonAndGoesOnFromThem) {
    const dem::World world = one_on_another(101, 0);
    const std::vector<Vec3> weight = buoyant_weights(world, {}, {});
    WeighedCopy copy(world, weight, {});
    EXPECT_EQ(copy.world().contacts.size(), 0U) << "both are held: their contact moves nothing";
    const dem::World whole = copy.whole();
    EXPECT_EQ(whole.contacts.size(), 1U);
    WeighedCopy next(whole, copy.scale(), weight);
    EXPECT_TRUE(next.bears_load(0));
    EXPECT_EQ(next.free_count(), 0);
    EXPECT_EQ(next.whole().contacts.size(), 1U);
}

/// Fines that fall between held grains of a lattice: some come to rest on others.
dem::World fines_in_a_lattice() {
    constexpr int edge = 3;
    const double fine = 0.3 * radius, spacing = 2.1 * radius, width = edge * spacing;
    dem::World world;
    world.cell.h = diagonal({width, width, 4 * width});
    const auto add = [&](const Vec3& place, double r, std::uint8_t is_fine) {
        add_grain(world.grains, place, r, world.material.density);
        world.grains.fine.back() = is_fine;
    };
    for (int a = 0; a < edge; ++a) {
        for (int b = 0; b < edge; ++b) {
            const double x = (a + 0.5) * spacing, y = (b + 0.5) * spacing;
            add({x, y, radius}, radius, 0);
            add({x + 0.3 * fine * a, y + 0.4 * fine * b, 2.5 * radius}, fine, 1);
            add({x + 0.2 * fine * b, y - 0.3 * fine, 3.5 * radius}, fine, 1);
        }
    }
    add({0, 0, radius - spacing}, radius, 0);
    for (int a = 0; a < edge; ++a) { // a floor below the gaps between them
        for (int b = 0; b < edge; ++b) {
            if (a + b > 0) {
                add({a * spacing, b * spacing, radius - spacing}, radius, 0);
            }
        }
    }
    return world;
}

TEST(WeighedCopy, MovesFinesThatRestForAWhileAsIfNoneSlept) {
    const dem::World world = fines_in_a_lattice();
    constexpr int times = 40; // T
    WeighedCopy copy(world, buoyant_weights(world, {}, {}), {}), sleepless = copy;
    copy.load({}, 0);
    copy.hold(times, {}, "rest");
    for (int k = 0; k < times; ++k) { // a load that changes so often lets none sleep
        sleepless.load({}, 0);
        sleepless.hold(1, {}, "rest");
    }
    for (std::size_t k = 0; k < copy.fines().size(); ++k) {
        EXPECT_LT(norm(copy.position(k) - sleepless.position(k)), 0.1 * radius) << k;
    }
    std::size_t asleep = 0;
    for (const std::uint32_t g : copy.fines()) {
        asleep += copy.world().grains.motion[g] == grains::Motion::Held ? 1 : 0;
    }
    EXPECT_GT(asleep, 0U);
    const dem::World whole = copy.whole();
    for (const std::uint32_t g : copy.fines()) {
        EXPECT_EQ(whole.grains.motion[g], grains::Motion::Free);
    }
    EXPECT_GT(whole.contacts.size(), asleep) << "each rests on something, asleep or awake";
}

TEST(WeighedCopy, WakesFinesWhenTheLoadChanges) {
    const dem::World world = one_on_another(1, 0);
    const std::vector<Vec3> weight = buoyant_weights(world, {}, {});
    WeighedCopy copy(world, weight, {});
    copy.load({}, 0);
    copy.hold(10, {}, "rest");
    EXPECT_EQ(copy.world().grains.motion[1], grains::Motion::Held);
    const Vec3 rested = copy.position(0);
    const std::vector<Vec3> force = {{}, -2 * weight[1]};
    copy.load(force, 1);
    copy.hold(5, {}, "ramp");
    EXPECT_GT(copy.position(0).z - rested.z, radius);
}

TEST(WeighedCopy, TakesStepsThatDoNotDependOnTheMassOfHeldGrains) {
    std::vector<double> time_step;
    for (const double lighter : {1.0, 0.01}) {
        dem::World world = one_on_another(1, 0);
        world.grains.mass.front() *= lighter;
        world.grains.inertia.front() *= lighter;
        WeighedCopy copy(world, buoyant_weights(world, {}, {}), {});
        copy.load({}, 0);
        copy.hold(1e-3, {}, "rest");
        time_step.push_back(copy.time_step());
    }
    EXPECT_GT(time_step[1], 0);
    EXPECT_NEAR(time_step[1] / time_step[0], 1, 1e-3); // a held grain is a million times as heavy as it is
}

} // namespace
} // namespace suffuse::erosion
