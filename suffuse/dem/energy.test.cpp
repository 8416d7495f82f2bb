#include "suffuse/dem/energy.hpp"

#include "suffuse/contact/hertz_spring.hpp"
#include "suffuse/contact/stress.hpp"

#include <gtest/gtest.h>

#include "tests/support/energy.hpp"
#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::dem {
namespace {

constexpr double r = 1e-4, overlap = 1e-7, dt = 1e-8, speed = 1e-3;

/// Two like grains that touch along x, and what their contact remembers.
World touching(const Vec3& shear_force = {}, const Vec3& bending = {}) {
    World world = test::two_grains(r, r, overlap, {});
    test::add_contact(world, 0, 1, shear_force);
    world.contacts.bending.set(0, bending);
    return world;
}

double normal_force() {
    return contact::normal_stiffness({}, r, r, 0) * overlap;
}

double coulomb_limit() {
    return std::tan(grains::Material{}.friction) * normal_force();
}

TEST(SpringEnergy, IsThatOfTheNormalShearAndBendingSpring) {
    const Vec3 shear{0, 0.5 * coulomb_limit(), 0}, bending{0, 0, 0.1 * r * normal_force()};
    const World world = touching(shear, bending);
    const grains::Material& m = world.material;
    const double kn = contact::normal_stiffness(m, r, r, 0), ks = m.shear_ratio * kn,
                 kr = m.rolling_stiffness * ks * r * r;
    const double closed = 0.5 * (kn * overlap * overlap + norm2(shear) / ks + norm2(bending) / kr);
    EXPECT_NEAR(spring_energy(world), closed, 1e-10 * closed); // the overlap is a 20,000th of the positions
}

TEST(SpringEnergy, OfElasticSpheresIsHertzs) {
    World world = touching({0, 1e-9, 0});
    world.material.law = grains::ContactLaw::HertzMindlin;
    world.material.modulus = 70e9;
    const double h = contact::hertz_modulus(world.material), root = std::sqrt(r / 2 * overlap);
    const double closed = 0.4 * h * root * overlap * overlap + 0.5 * 1e-18 / (1.5 * h * root * 2 * 0.7 / 1.7);
    EXPECT_NEAR(spring_energy(world), closed, 1e-9 * closed);
}

TEST(MeasuredDissipation, OfASlidingContactIsTheFrictionTimesItsSpeed) {
    World world = touching({0, -coulomb_limit(), 0}); // of a second grain that moves up
    world.grains.velocity[1] = {0, speed, 0};
    const double closed = coulomb_limit() * speed * 2 * r / (2 * r - overlap); // speed at the touching surfaces
    const Dissipation rate = measure_dissipation(world, dt, 0.2);
    EXPECT_NEAR(rate.slip, closed, 1e-6 * closed); // the spring turns with the contact, of second order in the step
    EXPECT_EQ(rate.rolling, 0);
}

TEST(MeasuredDissipation, OfAContactBelowItsLimitsIsNothing) {
    World world = touching({0, -0.9 * coulomb_limit(), 0});
    world.grains.velocity[1] = {0, speed, 0};
    world.grains.spin[0] = {0, 0, 1};
    const Dissipation rate = measure_dissipation(world, dt, 0.2);
    EXPECT_EQ(rate.slip, 0);
    EXPECT_EQ(rate.rolling, 0);
}

TEST(MeasuredDissipation, OfARollingContactIsItsLimitingMomentTimesTheRelativeSpin) {
    const double limit = grains::Material{}.rolling_friction * r * normal_force(), spin = 5;
    World world = touching({}, {0, 0, -limit}); // of a second grain that turns about z; the first one the other way
    world.grains.spin = {{0, 0, -spin}, {0, 0, spin}};
    const Dissipation rate = measure_dissipation(world, dt, 0.2);
    EXPECT_NEAR(rate.rolling, limit * 2 * spin, 1e-8 * limit * 2 * spin); // rounding of the overlap and of the spring
    EXPECT_EQ(rate.slip, 0);
}

/// Goes on step by step and looks at each.
EnergyBalance followed(World& world, StepPlan plan, int steps) {
    StepCaches caches;
    BalanceState seen;
    seen.equilibrium = measure_equilibrium(world);
    EnergyBalance balance = begin_balance(world, seen);
    for (int k = 0; k < steps; ++k) {
        seen.stress = step(world, caches, plan).stress;
        seen.equilibrium = measure_equilibrium(world);
        follow(balance, world, seen, plan.dt, plan.damping);
    }
    return balance;
}

// Nothing slips beyond the Coulomb limit: what is missing after the rebound is what changing contact area took.
TEST(EnergyBalance, OfAnObliqueElasticCollisionClosesWithTheSlipAtTheEdgeOfTheArea) {
    for (const double viscous : {0.0, 0.2}) {
        World world = test::two_grains(r, 1.5 * r, -1e-10, {});
        world.material.law = grains::ContactLaw::HertzMindlin;
        world.material.modulus = 70e9;
        world.material.friction = 1.5;
        world.material.viscous_damping = viscous;
        world.grains.velocity = {{speed, 0, 0}, {-speed, speed, 0}};
        const double before = test::energy_of(world).kinetic;
        const EnergyParts parts = followed(world, test::plan_of(1e-9, 0), 5'000).parts;
        EXPECT_FALSE(world.contacts.size() > 0 && world.contacts.touches(0));
        EXPECT_GT(parts.slip, 0.01 * before);
        EXPECT_EQ(parts.damping > 0.05 * before, viscous > 0);
        // First order in the step: without the slip at the edge, or the viscous part, it would not close.
        EXPECT_NEAR(parts.unaccounted(), 0, 0.05 * parts.slip);
    }
}

TEST(EnergyBalance, OfACollisionClosesWithWhatDampingTakes) {
    World world = test::two_grains(r, 1.5 * r, -1e-9, {});
    world.grains.velocity = {{speed, 0, 0}, {-speed, 0, 0}};
    const double before = test::energy_of(world).total();
    const EnergyParts parts = followed(world, test::plan_of(1e-9, 0.2), 20'000).parts; // meet and part
    EXPECT_FALSE(world.contacts.size() > 0 && world.contacts.touches(0));
    EXPECT_EQ(parts.work, 0);
    EXPECT_EQ(parts.slip, 0);
    EXPECT_NEAR(parts.springs, 0, 1e-12 * before);
    EXPECT_GT(parts.damping, 0.1 * before);
    EXPECT_NEAR(parts.unaccounted(), 0, 1e-3 * before); // motion is of half a step before the springs
}

TEST(EnergyBalance, OfAGlancingCollisionClosesWithWhatSlipTakes) {
    grains::Material slippery;
    slippery.friction = 0.05;
    World world = test::two_grains(r, r, -1e-9, slippery);
    world.grains.velocity = {{speed, speed, 0}, {-speed, -speed, 0}};
    const double before = test::energy_of(world).total();
    const EnergyParts parts = followed(world, test::plan_of(1e-9), 20'000).parts;
    EXPECT_EQ(parts.damping, 0);
    EXPECT_GT(parts.slip, 0.01 * before);
    EXPECT_NEAR(parts.unaccounted(), 0, 1e-3 * before);
}

} // namespace
} // namespace suffuse::dem
