// What stepping grains relies on, under every law of the table, unasked.

#include "suffuse/contact/springs.hpp"

#include "suffuse/dem/energy.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <gtest/gtest.h>

#include "tests/support/laws.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>

namespace suffuse::dem {
namespace {

constexpr double r1 = 1e-4, r2 = 1.5e-4, speed = 0.02; // [m], [m/s]

class SteppedSpring : public testing::TestWithParam<grains::Material> {};

INSTANTIATE_TEST_SUITE_P(EveryLaw, SteppedSpring, testing::ValuesIn(test::every_law()), test::law_test_name);

double motion_energy(const World& world) {
    double sum = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        sum += 0.5 * world.grains.mass[g] * norm2(world.grains.velocity[g]);
    }
    return sum;
}

TEST_P(SteppedSpring, GivesBackTheEnergyOfACollisionAndHoldsItMeanwhile) {
    World world = test::two_grains(r1, r2, -1e-10, GetParam());
    const double m1 = world.grains.mass[0], m2 = world.grains.mass[1];
    world.grains.velocity = {{m2 / (m1 + m2) * speed, 0, 0}, {-m1 / (m1 + m2) * speed, 0, 0}}; // their center rests
    const double start = motion_energy(world), dt = 1e-3 * stability_limit(world);
    StepCaches caches;
    double most_held = 0;
    bool met = false;
    for (int k = 0; k < 100'000; ++k) {
        step(world, caches, test::plan_of(dt));
        const bool touches = world.contacts.size() > 0 && world.contacts.touches(0);
        if (met && !touches) {
            break;
        }
        met = met || touches;
        const double held = spring_energy(world);
        most_held = std::max(most_held, held);
        ASSERT_NEAR((motion_energy(world) + held) / start, 1, 0.01); // motion is of half a step before the springs
    }
    EXPECT_TRUE(met);
    EXPECT_GT(most_held, 0.99 * start);
    EXPECT_NEAR(motion_energy(world) / start, 1, 1e-4);
}

TEST_P(SteppedSpring, StopsAGrainAtTheOverlapOfItsImpact) {
    World world = test::two_grains(r1, r1, -1e-10, GetParam());
    world.grains.motion[1] = grains::Motion::Held;
    world.grains.velocity[0] = {speed, 0, 0};
    const StepPlan plan = test::plan_of(1e-3 * stability_limit(world));
    StepCaches caches;
    double deepest = 0;
    for (int k = 0; k < 20'000; ++k) {
        step(world, caches, plan);
        deepest = std::max(deepest, world.contacts.size() > 0 ? world.contacts.overlap[0] : 0);
    }
    const double expected = r1 * contact::spring_of(GetParam()).overlap_of_impact(GetParam(), speed * speed);
    EXPECT_NEAR(deepest / expected, 1, 1e-3);
}

/// Two grains in a cell so narrow that each touches the other on both sides, and that swing against each other.
World squeezed_pair(const grains::Material& material, double overlap) {
    const double spacing = r1 + r2 - overlap;
    World world = test::empty_world(2 * spacing, material);
    world.reference_h = world.cell.h = diagonal({2 * spacing, 10 * r2, 10 * r2});
    test::add(world, {0.5 * spacing, 5 * r2, 5 * r2}, r1);
    test::add(world, {1.5 * spacing, 5 * r2, 5 * r2}, r2);
    return world;
}

TEST_P(SteppedSpring, StaysCalmAtTheStableTimeStep) {
    for (const double depth : {1e-4, 1e-2}) {
        World world = squeezed_pair(GetParam(), depth * r1);
        StepCaches caches;
        step(world, caches, test::plan_of(1e-12));
        world.grains.velocity = {{1e-4, 1e-5, 0}, {-1e-4, 0, 1e-5}};
        const double start = motion_energy(world) + spring_energy(world), dt = stable_time_step(world);
        const double squeezed = spring_energy(world);
        const auto moved = [&](double step_length, std::int64_t steps) {
            World copy = world;
            StepCaches fresh;
            test::advance(copy, fresh, test::plan_of(step_length), steps);
            return motion_energy(copy) + spring_energy(copy) - squeezed;
        };
        for (const std::int64_t steps : {10, 100, 3000}) {
            EXPECT_LT(moved(dt, steps), 4 * (start - squeezed)) << depth; // the scheme's own energy is stretched
        }
    }
}

// The step is looked at again when contacts are twice as far in: until then it has to hold.
TEST_P(SteppedSpring, HasAStepThatHoldsUntilContactsAreTwiceAsFarIn) {
    const double overlap = 1e-2 * r1;
    const double dt = stability_limit(squeezed_pair(GetParam(), overlap), {.damping = 0});
    EXPECT_LE(dt, 2 / highest_frequency(squeezed_pair(GetParam(), 2 * overlap), 400) * (1 + 1e-6));
}

} // namespace
} // namespace suffuse::dem
