// Momentum, energy and dissipation.

#include "suffuse/base/random.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <gtest/gtest.h>

#include "tests/support/energy.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <string>

namespace suffuse::dem {
namespace {

void stir(World& world, double speed, double spin) {
    RandomStream random(11, "stir");
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.velocity[g] = speed * Vec3{random.normal(), random.normal(), random.normal()};
        world.grains.spin[g] = spin * Vec3{random.normal(), random.normal(), random.normal()};
    }
}

TEST(Momentum, OfAPeriodicPackingIsKeptToRounding) {
    World world = test::reference_packing("packing500");
    stir(world, 0.05, 200); // collisions, slip and rolling all over
    double size = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        size += world.grains.mass[g] * norm(world.grains.velocity[g]);
    }
    const Vec3 before = test::momentum_of(world);
    StepCaches caches;
    test::advance(world, caches, test::plan_of(4e-8), 500);
    const double change = norm(test::momentum_of(world) - before) / size;
    EXPECT_LE(change, 1e-12);
    RecordProperty("change", std::to_string(1e15 * change) + "e-15");
}

TEST(Dissipation, OfASlidingContactIsFrictionTimesPlasticSlip) {
    // Two held grains that spin the same way: the contact slips in place under a constant overlap.
    grains::Material material;
    constexpr double r1 = 1e-4, r2 = 1.5e-4, overlap = 1e-8, rate = 10; // [m], [rad/s]
    World world = test::two_grains(r1, r2, overlap, material);
    for (const std::size_t g : {0, 1}) {
        world.grains.motion[g] = grains::Motion::Held;
        world.grains.spin[g] = {0, 0, rate};
    }
    StepCaches caches;
    const StepPlan plan = test::plan_of(1e-9);
    double work = 0;
    constexpr int steps = 80000;
    for (int k = 0; k < steps; ++k) {
        step(world, caches, plan);
        work -= (world.grains.torque[0].z + world.grains.torque[1].z) * rate * plan.dt;
    }
    const double kn = contact::normal_stiffness(material, r1, r2, 0), ks = material.shear_ratio * kn;
    const double friction = kn * overlap * std::tan(material.friction), slip = (r1 + r2) * rate * steps * plan.dt;
    const double stored = 0.5 * friction * friction / ks, dissipated = friction * (slip - friction / ks);
    ASSERT_GT(dissipated, 5 * stored);
    // The arms end in the middle of the overlap, 4e-5 of the size; one step in 1,000 until slip begins.
    EXPECT_NEAR(work / (stored + dissipated), 1, 1e-4);
    RecordProperty("error", std::to_string(1e6 * (work / (stored + dissipated) - 1)) + "e-6");
}

TEST(Dissipation, OfARollingContactIsItsLimitTimesPlasticRolling) {
    grains::Material material;
    constexpr double r = 1e-4, overlap = 1e-8, rate = 10;
    World world = test::two_grains(r, r, overlap, material);
    for (const std::size_t g : {0, 1}) {
        world.grains.motion[g] = grains::Motion::Held;
        world.grains.spin[g] = {0, 0, g == 0 ? rate : -rate}; // gear wheels: rolling without slip
    }
    StepCaches caches;
    const StepPlan plan = test::plan_of(1e-9);
    double work = 0;
    constexpr int steps = 20000;
    for (int k = 0; k < steps; ++k) {
        step(world, caches, plan);
        work -= (world.grains.torque[0].z - world.grains.torque[1].z) * rate * plan.dt;
    }
    const double kn = material.modulus * r, kr = material.rolling_stiffness * material.shear_ratio * kn * r * r;
    const double limit = material.rolling_friction * r * kn * overlap, roll = 2 * rate * steps * plan.dt;
    const double stored = 0.5 * limit * limit / kr, dissipated = limit * (roll - limit / kr);
    ASSERT_GT(dissipated, 5 * stored);
    EXPECT_NEAR(work / (stored + dissipated), 1, 1e-3); // one step in a thousand until the limit
}

TEST(Energy, OfAVibratingLatticeDoesNotDrift) {
    // Eight grains pressed together, all springs at work, none at its limit, nothing damps.
    grains::Material material;
    material.friction = 1.5;
    material.rolling_friction = material.twisting_friction = -1;
    material.twisting_stiffness = 2;
    constexpr double r = 1e-4, spacing = 2 * r * (1 - 1e-3);
    World world = test::empty_world(2 * spacing, material);
    for (int k = 0; k < 8; ++k) {
        test::add(
            world,
            spacing * Vec3{static_cast<double>(k & 1), static_cast<double>(k >> 1 & 1), static_cast<double>(k >> 2)}, r
        );
    }
    StepCaches caches;
    step(world, caches, test::plan_of(1e-12));
    const double pressed = test::energy_of(world).elastic;
    stir(world, 1e-3, 10); // overlaps change by a hundredth
    const StepPlan plan = test::plan_of(0.05 * 2 / highest_frequency(world, 200));
    // Kinetic energy from the velocities half a step before and after the springs' state: with it the scheme conserves
    // the energy of linear springs exactly, so that what changes is the law's or the geometry's.
    const auto energy_now = [&] {
        const grains::Grains before = world.grains;
        step(world, caches, plan);
        double energy = test::energy_of(world).elastic;
        for (std::size_t g = 0; g < before.size(); ++g) {
            energy += 0.5 * before.mass[g] * dot(before.velocity[g], world.grains.velocity[g]);
            energy += 0.5 * before.inertia[g] * dot(before.spin[g], world.grains.spin[g]);
        }
        return energy;
    };
    const double start = energy_now();
    test::advance(world, caches, plan, 100'000);
    const double change = energy_now() - start;
    EXPECT_LE(std::abs(change) / start, 1e-6);
    EXPECT_LE(std::abs(change) / (start - pressed), 1e-3); // of the vibration alone: turning of contacts, second order
    RecordProperty("drift_of_total", std::to_string(1e9 * change / start) + "e-9");
    RecordProperty("drift_of_vibration", std::to_string(1e6 * change / (start - pressed)) + "e-6");
}

TEST(Energy, OfGrainsWithoutContactsStaysWhereItIs) {
    World world = test::empty_world(1);
    test::add(world, {0.2, 0.2, 0.2}, 0.01);
    test::add(world, {0.7, 0.7, 0.7}, 0.01);
    stir(world, 1, 5);
    const double before = test::energy_of(world).total();
    StepCaches caches;
    test::advance(world, caches, test::plan_of(1e-5, 0.5), 100); // damping takes a share of forces: there are none
    EXPECT_EQ(test::energy_of(world).total(), before);
}

} // namespace
} // namespace suffuse::dem
