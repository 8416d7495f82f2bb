// Bonds between two grains that are moved apart or past each other: strengths, breakage, and what is left.

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <string>

namespace suffuse::dem {
namespace {

constexpr double r1 = 1e-4, r2 = 1.5e-4, smaller2 = r1 * r1, slow = 1e-2; // [m], [m2], [m/s]
constexpr double dt = 1e-8, pull_off = 2e6 * smaller2;                    // [s], [N]

grains::Material sticky(double adhesion_shear = 3e6) {
    grains::Material material;
    material.adhesion_normal = 2e6;
    material.adhesion_shear = adhesion_shear;
    return material;
}

/// Two held grains, overlapping by `overlap`, after a first step that makes their bond; the second then moves.
struct Pair {
    World world;
    StepCaches caches;
    StepPlan plan = test::plan_of(dt);

    Pair(const grains::Material& material, double overlap, const Vec3& velocity)
        : world(test::two_grains(r1, r2, overlap, material)) {
        world.grains.motion[0] = world.grains.motion[1] = grains::Motion::Held;
        step(world, caches, plan);
        world.grains.velocity[1] = velocity;
    }

    /// Steps until nothing touches any more or the time is over; `seen` looks at every state.
    template <class Seen>
    void run(double time, Seen&& seen) {
        for (double t = 0; t < time; t += dt) {
            step(world, caches, plan);
            seen();
            if (inspect_contacts(world).empty()) {
                return;
            }
        }
    }
};

TEST(Adhesion, PullOffForceIsTheStrengthTimesTheSmallerRadiusSquared) {
    Pair pair(sticky(), 1e-9, {slow, 0, 0});
    double most = 0;
    pair.run(1e-3, [&] { most = std::max(most, -pair.world.grains.force[1].x); }); // pulls the second grain back
    EXPECT_TRUE(inspect_contacts(pair.world).empty());
    EXPECT_NEAR(most / pull_off, 1, 1e-3); // the last step before the break: kn v dt = 4e-6 N of 2e-2 N
    EXPECT_LE(most, pull_off * (1 + 1e-12));
    RecordProperty("error", std::to_string(1e6 * (most / pull_off - 1)) + "e-6");
}

TEST(Adhesion, PullOffForceIsLowerWhereTheShearStrengthVanishesBefore) {
    // The shear strength A_s + Fn tan(phi) is used up at the pull A_s/tan(phi); any shear, be it rounding, breaks the
    // bond.
    Pair pair(sticky(3e5), 1e-9, {slow, 1e-6 * slow, 0});
    double most = 0;
    pair.run(1e-3, [&] { most = std::max(most, -pair.world.grains.force[1].x); });
    EXPECT_NEAR(most / (3e5 * smaller2 / std::tan(pair.world.material.friction)), 1, 2e-3); // one step of pull
}

TEST(Adhesion, ABrokenBondDoesNotHealWhenTheGrainsComeBackUnlessTheMaterialStillBonds) {
    for (const bool bonds_anew : {true, false}) {
        Pair pair(sticky(), 1e-9, {slow, 0, 0});
        pair.run(1e-3, [] {});
        if (!bonds_anew) {
            pair.world.material.adhesion_normal = pair.world.material.adhesion_shear = 0;
        }
        pair.world.grains.velocity[1] = {-slow, 0, 0};
        test::advance(pair.world, pair.caches, pair.plan, static_cast<std::int64_t>(2e-9 / slow / dt) + 6000);
        pair.world.grains.velocity[1] = {slow, 0, 0};
        double most = 0;
        pair.run(1e-3, [&] { most = std::max(most, -pair.world.grains.force[1].x); });
        EXPECT_NEAR(most, bonds_anew ? pull_off : 0, 1e-3 * pull_off);
    }
}

TEST(Adhesion, AMeanContactForceIsThatOfTheContactsLookedAtAlsoWhereABondBreaks) {
    Pair pair(sticky(3e5), 1e-9, {slow, 1e-6 * slow, 0});
    pair.run(1e-3, [&] {
        const std::vector<ContactView> views = inspect_contacts(pair.world);
        if (!views.empty()) {
            const double force = norm(views[0].normal_force + views[0].shear_force);
            EXPECT_NEAR(measure_equilibrium(pair.world).mean_contact_force, force, 1e-12 * pull_off);
        }
    });
}

TEST(Adhesion, AfterItsRemovalTheContactOpensWithoutForce) {
    Pair pair(sticky(), 1e-9, {slow, 0, 0});
    pair.world.material.adhesion_normal = pair.world.material.adhesion_shear = 0;
    std::fill(pair.world.contacts.bonded.begin(), pair.world.contacts.bonded.end(), std::uint8_t{0});
    double most_pull = 0, opened_at = 0;
    pair.run(1e-3, [&] {
        most_pull = std::max(most_pull, -pair.world.grains.force[1].x);
        opened_at = norm(pair.world.grains.position[1] - pair.world.grains.position[0]);
    });
    EXPECT_EQ(most_pull, 0);
    EXPECT_NEAR(opened_at - (r1 + r2), 0, 3 * slow * dt); // seen at the next step
}

/// Largest shear force of a contact pressed by `overlap` while the second grain moves past the first, and the force
/// after.
std::pair<double, double> shear_strength(const grains::Material& material, double overlap) {
    Pair pair(material, overlap, {0, slow, 0});
    double most = 0, after = 0;
    pair.run(5e-3 * r1 / slow, [&] {
        after = norm(pair.world.contacts.shear_force[0]);
        most = std::max(most, after);
    });
    return {most, after};
}

TEST(Adhesion, ShearStrengthIsTheBondPlusFrictionAndFrictionAloneIsLeft) {
    const grains::Material material = sticky(3e5);
    const double kn = 2 * material.modulus * r1 * r2 / (r1 + r2), overlap = 1e-7, normal = kn * overlap;
    const double bond_shear = 3e5 * smaller2;
    const auto [most, after] = shear_strength(material, overlap);
    const double friction = normal * std::tan(material.friction);
    // Moving sideways by 5e-7 m lifts the grain by 5e-10 m, half a percent of the overlap.
    EXPECT_NEAR(most / (bond_shear + friction), 1, 1e-2);
    EXPECT_NEAR(after / friction, 1, 1e-2);
    RecordProperty("error", std::to_string(most / (bond_shear + friction) - 1));
}

TEST(Adhesion, WithoutItTheShearStrengthIsFriction) {
    const grains::Material material;
    const double kn = 2 * material.modulus * r1 * r2 / (r1 + r2), overlap = 1e-7;
    const auto [most, after] = shear_strength(material, overlap);
    EXPECT_NEAR(most / (kn * overlap * std::tan(material.friction)), 1, 1e-2);
    EXPECT_NEAR(after / most, 1, 1e-2);
}

TEST(Adhesion, BondsAreMadeOnlyByContactsThatBeginWhileTheMaterialBonds) {
    Pair old({}, 1e-9, {});
    old.world.material = sticky(); // from now on
    test::advance(old.world, old.caches, old.plan, 3);
    ASSERT_EQ(old.world.contacts.bonded.size(), 1U);
    EXPECT_EQ(old.world.contacts.bonded[0], 0);
    Pair young(sticky(), 1e-9, {});
    ASSERT_EQ(young.world.contacts.bonded.size(), 1U);
    EXPECT_EQ(young.world.contacts.bonded[0], 1);
}

} // namespace
} // namespace suffuse::dem
