#include "suffuse/dem/stable_dt.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/dem/equilibrium.hpp"

#include <gtest/gtest.h>

#include "tests/support/energy.hpp"
#include "tests/support/worlds.hpp"
#include <cmath>
#include <string>

namespace suffuse::dem {
namespace {

constexpr double radius = 1e-4, overlap = 1e-8; // [m]

double stiffness(const World& world) {
    return world.material.modulus * radius; // of two equal grains
}

/// Two equal grains with a contact.
World pair_of(double shear_ratio, double rolling, double twisting) {
    grains::Material material;
    material.shear_ratio = shear_ratio;
    material.rolling_stiffness = rolling;
    material.twisting_stiffness = twisting;
    World world = test::two_grains(radius, radius, overlap, material);
    test::add_contact(world, 0, 1);
    return world;
}

TEST(HighestFrequency, OfAPairIsThatOfItsStiffestMode) {
    struct Mode {
        const char* name;
        double shear_ratio, rolling, twisting;
        double square; ///< omega2 m / kn
    };

    // Apart: 2 kn/m. Slip, with both grains turning the same way: ks (2/m + 2 r2/I) = 7 ks/m. Rolling, opposite ways:
    // 2 kr/I = 5 alpha ks/m. Twisting about the normal: the same with its own stiffness.
    for (const Mode& mode :
         {Mode{"normal", 0.1, 0.2, 0.3, 2}, Mode{"slip", 0.8, 1, 0.5, 7 * 0.8},
          Mode{"rolling", 0.42, 7.5, 2, 5 * 7.5 * 0.42}, Mode{"twisting", 0.42, 2, 9, 5 * 9 * 0.42}}) {
        const World world = pair_of(mode.shear_ratio, mode.rolling, mode.twisting);
        const double expected = std::sqrt(mode.square * stiffness(world) / world.grains.mass[0]);
        EXPECT_NEAR(highest_frequency(world, 400) / expected, 1, 1e-6) << mode.name;
        const double usual = highest_frequency(world) / expected; // comes from below
        EXPECT_LE(usual, 1 + 1e-12) << mode.name;
        EXPECT_GE(usual, 0.95) << mode.name;
    }
}

TEST(HighestFrequency, OfElasticSpheresIsThatOfTheirStiffnessAtTheOverlap) {
    World world = pair_of(0.42, 0, 0);
    world.material.law = grains::ContactLaw::HertzMindlin;
    world.material.modulus = 70e9;
    const double kn = 1.5 * contact::hertz_modulus(world.material) * std::sqrt(radius / 2 * overlap);
    const double ks = kn * 2 * 0.7 / 1.7, expected = std::sqrt(7 * ks / world.grains.mass[0]); // slip is the stiffest
    EXPECT_NEAR(highest_frequency(world, 400) / expected, 1, 1e-6);
    // The step allows for twice that overlap: the frequency grows with its fourth root. Or with that of a pressure.
    EXPECT_NEAR(stability_limit(world, {.damping = 0}) * expected / 2, std::pow(2, -0.25), 1e-3);
    const double pressed = contact::mean_overlap_at(world.material, 1e6) * radius;
    ASSERT_GT(pressed, overlap);
    EXPECT_LT(
        stability_limit(world, {.damping = 0, .pressure = 1e6}) * expected / 2,
        std::pow(2 * pressed / overlap, -0.25) * (1 + 1e-3)
    );
}

TEST(StableTimeStep, OfAContactThatIsDampedIsShorterAndJustStable) {
    World world = pair_of(0.1, 0, 0); // the normal spring is the stiffest
    world.material.friction = 0;
    world.material.viscous_damping = 0.5;
    const double limit = stability_limit(world, {.damping = 0});
    EXPECT_NEAR(limit / (2 / highest_frequency(world, 400)), std::sqrt(1.25) - 0.5, 1e-3);
    // Held together by a bond, a disturbed pair comes to rest below the limit, and blows up above it.
    const auto motion_after = [&](double share, std::int64_t steps) {
        World pair = pair_of(0.1, 0, 0);
        pair.material.viscous_damping = 0.5;
        pair.material.adhesion_normal = pair.material.adhesion_shear = 1e9;
        pair.contacts.bonded.assign(1, 1);
        StepCaches caches;
        test::advance(pair, caches, test::plan_of(share * limit, 0), steps);
        return std::abs(pair.grains.velocity[1].x - pair.grains.velocity[0].x);
    };
    EXPECT_LT(motion_after(0.98, 100), 0.3 * motion_after(0.98, 50));
    EXPECT_GT(motion_after(1.02, 100), 3 * motion_after(1.02, 50));
}

TEST(HighestFrequency, OfFrictionlessGrainsIsThatOfNormalSpringsUnlessTheySpin) {
    World world = pair_of(0.42, 7.5, 2);
    world.material.friction = 0;
    const double normal = std::sqrt(2 * stiffness(world) / world.grains.mass[0]);
    const double rolling = std::sqrt(5 * 7.5 * 0.42 * stiffness(world) / world.grains.mass[0]);
    EXPECT_NEAR(highest_frequency(world, 400) / normal, 1, 1e-6);
    EXPECT_GT(stability_limit(world, {.damping = 0}), 0.99 * 2 / normal);
    world.grains.spin[1] = {0, 1e-9, 0};
    EXPECT_NEAR(highest_frequency(world, 400) / rolling, 1, 1e-6);
    EXPECT_LT(stability_limit(world, {.damping = 0}), 1.05 * 2 / rolling);
}

/// A row of equal grains across the whole cell, touching across its faces.
World chain(int count) {
    grains::Material material;
    material.shear_ratio = 1e-9;                               // the normal springs alone
    material.adhesion_normal = material.adhesion_shear = 1e12; // contacts may pull
    const double spacing = 2 * radius - overlap;
    World world = test::empty_world(count * spacing, material);
    world.reference_h = world.cell.h = diagonal({count * spacing, 10 * radius, 10 * radius});
    for (int k = 0; k < count; ++k) {
        test::add(world, {(k + 0.5) * spacing, 5 * radius, 5 * radius}, radius);
    }
    StepCaches caches;
    step(world, caches, test::plan_of(1e-12));
    return world;
}

TEST(HighestFrequency, OfAChainIsTwiceTheRootOfStiffnessOverMass) {
    const World world = chain(20);
    const double expected = 2 * std::sqrt(stiffness(world) / world.grains.mass[0]);
    EXPECT_NEAR(highest_frequency(world, 3000) / expected, 1, 1e-6); // neighbors in the spectrum are 1 % away
    const double usual = highest_frequency(world) / expected;
    EXPECT_GE(usual, 0.95);
    EXPECT_LE(usual, 1 + 1e-12);
}

TEST(HighestFrequency, WithoutContactsIsZero) {
    World world = pair_of(0.42, 7.5, 0);
    world.clock.step = 1; // whose contacts are known
    world.contacts.normal.set(0, {});
    EXPECT_EQ(highest_frequency(world), 0);
}

/// Vibration of a chain after many steps of `share` of the stability limit without damping, relative to its start.
double growth(double share, int steps = 60) {
    World world = chain(20);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        world.grains.velocity[g].x = 1e-7 * (g % 2 == 0 ? 1 : -1); // the stiffest mode
    }
    StepCaches caches;
    const double limit = 2 / (2 * std::sqrt(stiffness(world) / world.grains.mass[0]));
    const double start = test::energy_of(world).kinetic;
    test::advance(world, caches, test::plan_of(share * limit), steps);
    return test::energy_of(world).kinetic / start;
}

TEST(StabilityLimit, IsTwoOverTheHighestFrequency) {
    EXPECT_LT(growth(0.99), 100); // bounded: near the limit the scheme's conserved energy stretches by 1/(1 - share^2)
    EXPECT_GT(growth(1.01), 1e4); // until forces are beyond all reason, where the step stops
}

/// Whether the stiffest mode of a chain grows under local damping, from one of several phases: above the limit some
/// orbits still die away.
bool vibration_grows(double share, double damping) {
    const double frequency = 2 * std::sqrt(stiffness(chain(2)) / chain(2).grains.mass[0]), speed = 1e-5;
    for (const double phase : {0.1, 0.5, 1.1, 1.7, 2.3, 2.9}) {
        World world = chain(2);
        for (std::size_t g = 0; g < 2; ++g) {
            const double way = g == 0 ? 1 : -1;
            world.grains.velocity[g].x = way * speed * std::cos(phase);
            world.grains.position[g].x += way * speed / frequency * std::sin(phase);
        }
        StepCaches caches;
        try {
            test::advance(world, caches, test::plan_of(share * 2 / frequency, damping), 400);
        } catch (const StateError&) {
            return true;
        }
        if (std::abs(world.grains.velocity[0].x - world.grains.velocity[1].x) > 4 * speed) {
            return true;
        }
    }
    return false;
}

TEST(StabilityLimit, IsLowerUnderLocalDampingWhichRaisesTheForcesThatBrake) {
    for (const double damping : {0.2, 0.5, 0.9}) {
        const double limit = share_when_damped(damping, 0);
        EXPECT_NEAR(limit, 1 / std::sqrt(1 + damping), 1e-15);
        EXPECT_FALSE(vibration_grows(0.98 * limit, damping)) << damping;
        EXPECT_TRUE(vibration_grows(1.02 * limit, damping)) << damping;
    }
    EXPECT_NEAR(share_when_damped(0, 0.5), std::sqrt(1.25) - 0.5, 1e-15);
}

TEST(StabilityLimit, BeyondItTheStepStopsWhenForcesAreBeyondAllReason) {
    EXPECT_THROW(growth(1.05, 1000), StateError);
}

/// A grain of `radius` that touches one so many times as large.
World unequal_pair(double times, double twisting = 0.7) {
    grains::Material material;
    material.shear_ratio = 0.42;
    material.rolling_stiffness = 7.5;
    material.twisting_stiffness = twisting;
    World world = test::two_grains(radius, times * radius, overlap, material);
    test::add_contact(world, 0, 1);
    return world;
}

Inertia inertia_of(const World& world, std::size_t g) {
    return {world.grains.radius[g], world.grains.mass[g], world.grains.inertia[g]};
}

TEST(PairFrequency, IsThatOfTheNetworkOfTwoGrains) {
    for (const double times : {1.0, 1.2, 2.0, 4.5, 10.0}) {
        for (const double twisting : {0.7, 40.0}) {
            const World world = unequal_pair(times, twisting);
            const double closed = pair_frequency(world.material, 0.42, inertia_of(world, 0), inertia_of(world, 1));
            EXPECT_NEAR(highest_frequency(world, 2000) / closed, 1, 1e-6) << times; // converged
        }
    }
}

TEST(StableTimeStep, IsAShareOfTheLimitAndHoldsForContactsToCome) {
    for (const double times : {1.0, 2.0, 4.5, 10.0}) {
        World world = unequal_pair(times);
        const double limit = 2 / highest_frequency(world, 2000);
        EXPECT_NEAR(stability_limit(world, {.damping = 0}) / limit, 1, 1e-6) << times;
        world.contacts = {};
        world.grains.position[1] += Vec3{4 * radius, 4 * radius, 4 * radius}; // apart
        EXPECT_NEAR(stability_limit(world, {.damping = 0}) / limit, 1, 1e-6) << times;
    }
}

TEST(StableTimeStep, AllowsForGrainsOfManyNeighborsWhileFewerContactsTouchThanThereAreGrains) {
    const World sparse = unequal_pair(1);
    EXPECT_NEAR(stable_time_step(sparse, {}, 1) * quicker_than_pair / stability_limit(sparse), 1, 1e-12);
    EXPECT_NEAR(stable_time_step(chain(20), {}, 1) / stability_limit(chain(20)), 1, 1e-12); // a contact a grain
}

TEST(StableTimeStep, BeyondTheLimitUnderItsDampingIsRefused) {
    const World world = unequal_pair(1);
    const double limit = 2 / highest_frequency(world, 2000);
    EXPECT_NO_THROW(check_time_step(world, 0.99 * limit, 0));
    EXPECT_THROW(check_time_step(world, 0.99 * limit, 0.2), CaseError);
    EXPECT_NO_THROW(check_time_step(world, 0.72 * limit, 0.9));
    EXPECT_THROW(check_time_step(world, 0.73 * limit, 0.9), CaseError);
}

TEST(StableTimeStep, BeforeTheFirstStepIsThatOfTheContactsThatItWillFind) {
    World world = test::reference_packing("packing2000");
    ASSERT_EQ(world.contacts.size(), 0U);
    const double before = stable_time_step(world);
    StepCaches caches;
    step(world, caches, test::plan_of(1e-12));
    EXPECT_NEAR(stable_time_step(world) / before, 1, 1e-6); // the cell has moved by a step of 1e-12 s
    EXPECT_LE(before, 2 / highest_frequency(world, 2000));
}

TEST(StableTimeStep, IsDueAgainAfterAThousandStepsAndWhenTheNetworkHasGrown) {
    EXPECT_TRUE(time_step_is_due(0, 100, 100));
    EXPECT_FALSE(time_step_is_due(50, 120, 100));
    EXPECT_TRUE(time_step_is_due(50, 121, 100));
    EXPECT_TRUE(time_step_is_due(50, 1, 0));
    EXPECT_TRUE(time_step_is_due(1000, 100, 100));
}

TEST(StableTimeStep, OfThePackingIsNearTheReferencesAndCalm) {
    World world = test::reference_packing("packing500");
    StepCaches caches;
    step(world, caches, test::plan_of(1e-12));
    const double dt = stable_time_step(world);
    // The reference's time stepper allows 0.271 to 0.339 of the P-wave step, 1.37e-7 s, for this packing.
    EXPECT_GT(dt, 0.2 * 1.3655e-7);
    EXPECT_LT(dt, 0.5 * 1.3655e-7);
    test::advance(world, caches, test::plan_of(dt, 0.2), 2000);
    EXPECT_LT(measure_equilibrium(world).unbalanced_force, 1e-3);
    RecordProperty("share_of_limit", std::to_string(dt * highest_frequency(world, 2000) / 2));
    EXPECT_LT(dt * highest_frequency(world, 2000) / 2, 0.9);
}

} // namespace
} // namespace suffuse::dem
