// Two grains that meet head on, through the step that the program runs: closed forms of the linear spring, of elastic
// spheres, and of what damps them.

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <string>

namespace suffuse::dem {
namespace {

constexpr double speed = 0.02; // of approach [m/s]

/// Two free grains of different sizes on their way to each other, `gap` [m] apart, along `n`; their common center
/// rests.
World approaching(double gap, const Vec3& n = {1, 0, 0}) {
    World world = test::two_grains(1e-4, 1.5e-4, -gap, {}, n);
    const double m1 = world.grains.mass[0], m2 = world.grains.mass[1];
    world.grains.velocity[0] = m2 / (m1 + m2) * speed * n;
    world.grains.velocity[1] = -m1 / (m1 + m2) * speed * n;
    return world;
}

double stiffness() {
    const double modulus = grains::Material{}.modulus;
    return 2 * modulus * 1e-4 * 1.5e-4 / 2.5e-4;
}

double effective_mass() {
    const World world = approaching(0);
    return 1 / (1 / world.grains.mass[0] + 1 / world.grains.mass[1]);
}

/// pi sqrt(m/k): half a period of the spring.
double contact_time() {
    return pi * std::sqrt(effective_mass() / stiffness());
}

struct Collision {
    double duration = 0, max_overlap = 0, restitution = 0;
};

Collision collide(World world, double dt, double damping, const Vec3& n = {1, 0, 0}) {
    Collision result;
    StepCaches caches;
    const StepPlan plan = test::plan_of(dt, damping);
    bool met = false;
    for (int k = 0; k < 10'000'000; ++k) {
        step(world, caches, plan);
        const bool touches = world.contacts.size() > 0 && world.contacts.touches(0);
        if (met && !touches) {
            break;
        }
        met = met || touches;
        result.duration += touches ? dt : 0;
        result.max_overlap = std::max(result.max_overlap, touches ? world.contacts.overlap[0] : 0);
    }
    result.restitution = dot(world.grains.velocity[1] - world.grains.velocity[0], n) / speed;
    return result;
}

TEST(Collision, LastsHalfAPeriodOfTheSpring) {
    const double dt = contact_time() / 2000;
    // Seen in whole steps: one step at either end.
    EXPECT_NEAR(collide(approaching(1e-9), dt, 0).duration / contact_time(), 1, 2.0 / 2000);
}

TEST(Collision, DeepestOverlapIsSpeedOverFrequency) {
    const double expected = speed * std::sqrt(effective_mass() / stiffness());
    const auto error = [&](double steps) {
        return std::abs(collide(approaching(1e-9), contact_time() / steps, 0).max_overlap / expected - 1);
    };
    EXPECT_LT(error(2000), 1e-6); // second order: the largest of samples of a sine, (pi/2000)^2/8
    RecordProperty("overlap_error_at_2000_steps", std::to_string(1e6 * error(2000)) + "e-6");
}

/// Largest error of an undamped rebound, over where within a step the grains meet.
double worst_rebound_error(double steps) {
    double worst = 0;
    for (int k = 0; k < 20; ++k) {
        const double dt = contact_time() / steps, gap = (3 + k / 20.0) * speed * dt;
        worst = std::max(worst, std::abs(collide(approaching(gap), dt, 0).restitution - 1));
    }
    return worst;
}

TEST(Collision, WithoutDampingLosesNoEnergyAndTheErrorFallsWithTheStep) {
    const double coarse = worst_rebound_error(50), fine = worst_rebound_error(200);
    RecordProperty("rebound_error_at_50_steps", std::to_string(1e6 * coarse) + "e-6");
    RecordProperty("rebound_error_at_200_steps", std::to_string(1e6 * fine) + "e-6");
    EXPECT_LT(coarse, 1e-4);
    EXPECT_LT(fine, coarse / 16); // second order or better
}

class LocalDamping : public testing::TestWithParam<double> {};

TEST_P(LocalDamping, MeetsTheClosedFormRestitutionInAnyDirection) {
    // Approach is braked by 1 + lambda, rebound driven by 1 - lambda: e2 is their ratio.
    const double lambda = GetParam(), expected = std::sqrt((1 - lambda) / (1 + lambda));
    for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{1 / std::sqrt(3.0), 1 / std::sqrt(3.0), -1 / std::sqrt(3.0)}}) {
        const double e = collide(approaching(1e-9, n), contact_time() / 2000, lambda, n).restitution;
        EXPECT_NEAR(e, expected, 1e-5); // second order in the step, doubled where the motion turns
        RecordProperty("error", std::to_string(1e6 * (e - expected)) + "e-6");
    }
}

INSTANTIATE_TEST_SUITE_P(
    Coefficients, LocalDamping, testing::Values(0.05, 0.1, 0.2, 0.3, 0.4, 0.7),
    [](const auto& test) { return std::to_string(static_cast<int>(std::round(100 * test.param))); }
);

class ViscousDamping : public testing::TestWithParam<double> {};

TEST_P(ViscousDamping, MeetsTheClosedFormRestitutionOfALinearSpring) {
    // Half a period of the damped oscillator: e = exp(-pi z/sqrt(1 - z2)).
    const double z = GetParam(), expected = std::exp(-pi * z / std::sqrt(1 - z * z));
    World world = approaching(1e-9);
    world.material.viscous_damping = z;
    EXPECT_NEAR(collide(world, contact_time() / 20'000, 0).restitution, expected, 2e-4); // first order in the step
}

INSTANTIATE_TEST_SUITE_P(Shares, ViscousDamping, testing::Values(0.05, 0.3, 0.7), [](const auto& test) {
    return std::to_string(static_cast<int>(std::round(100 * test.param)));
});

/// The approaching grains as elastic spheres of glass.
World elastic_spheres() {
    World world = approaching(1e-9);
    world.material.law = grains::ContactLaw::HertzMindlin;
    world.material.modulus = 70e9;
    return world;
}

// Overlap (15 m v2/(16 E* sqrt(R)))^(2/5) = d, duration 2.9432 d/v [Hertz 1882; Johnson 1985, 11.4].
TEST(ElasticCollision, LastsAndGoesAsDeepAsHertzComputed) {
    const World world = elastic_spheres();
    const double contact_modulus = 70e9 / (2 * (1 - 0.09)), radius = 1e-4 * 1.5e-4 / 2.5e-4;
    const double depth =
        std::pow(15 * effective_mass() * speed * speed / (16 * contact_modulus * std::sqrt(radius)), 0.4);
    const double duration = 2.9432 * depth / speed, dt = duration / 2000;
    const Collision collision = collide(world, dt, 0);
    EXPECT_NEAR(collision.max_overlap / depth, 1, 1e-5);
    EXPECT_NEAR(collision.duration / duration, 1, 2.0 / 2000);
    EXPECT_NEAR(collision.restitution, 1, 1e-5);
}

TEST(ElasticCollision, WithViscousDampingRestoresTheSameShareAtAnySpeed) {
    const auto restitution = [](double slower) {
        World world = elastic_spheres();
        world.material.viscous_damping = 0.2;
        for (Vec3& velocity : world.grains.velocity) {
            velocity = slower * velocity;
        }
        return collide(world, 1e-10, 0).restitution / slower;
    };
    EXPECT_NEAR(
        restitution(1), restitution(0.1), 1e-3
    );                                        // damping grows with the root of the stiffness: no scale is left
    EXPECT_NEAR(restitution(1), 0.49, 0.005); // integrated apart, by another program
}

TEST(Collision, TheCommonCenterStaysAtRest) {
    World world = approaching(1e-9);
    StepCaches caches;
    test::advance(world, caches, test::plan_of(contact_time() / 100), 300);
    const auto& g = world.grains;
    EXPECT_LE(norm(g.mass[0] * g.velocity[0] + g.mass[1] * g.velocity[1]), 1e-14 * g.mass[1] * speed);
}

TEST(Collision, ComesAfterALongFlightThatNobodyWatches) {
    // Both grains sleep, for they are in no row of the contact table, until they may have come near each other.
    const double gap = 2e-4, dt = contact_time() / 100;
    World world = approaching(gap);
    StepCaches caches;
    std::int64_t asleep = 0;
    for (double time = 0; time < gap / speed + 2 * contact_time(); time += 50 * dt) {
        advance(world, caches, test::plan_of(dt), 50);
        asleep += caches.neighborhood.sum_plan().awake_end[0] == 0 ? 1 : 0;
    }
    EXPECT_GT(asleep, 10);
    EXPECT_NEAR(world.grains.velocity[1].x - world.grains.velocity[0].x, speed, 1e-3 * speed);
}

} // namespace
} // namespace suffuse::dem
