#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::dem {
namespace {

constexpr double dt = 4.1e-8; // [s]

StepPlan shearing(Mode mode) {
    StepPlan plan = test::plan_of(dt, 0.2);
    plan.mode = mode;
    plan.loading = isotropic_stress(100e3);
    plan.loading.axis[2] = {cell::Control::StrainRate, 10};
    return plan;
}

struct End {
    Mat3 stress;
    double void_ratio;
    std::int64_t contacts;
    std::uint64_t hash;
};

/// The packing of 500 grains, settled by `mode` and sheared for 2,000 steps.
End sheared(Mode mode) {
    World world = test::reference_packing("packing500");
    StepCaches caches;
    StepPlan plan = shearing(mode);
    const cell::Loading shear = plan.loading;
    plan.loading = isotropic_stress(100e3);
    advance(world, caches, plan, 2000);
    plan.loading = shear;
    const Mat3 stress = advance(world, caches, plan, 2000).stress;
    return {stress, void_ratio(world), measure_equilibrium(world).contacts, state_hash(world)};
}

TEST(FastMode, KeepsThePhysicsOfAShearedPacking) {
    // A packing is chaotic: as far as the reference's trajectories may part from ours after 2,000 steps.
    const End exact = sheared(Mode::Reference), fast = sheared(Mode::Fast);
    for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR(fast.stress(a, a) / exact.stress(a, a), 1, 2e-3);
    }
    EXPECT_NEAR(fast.void_ratio, exact.void_ratio, 1e-5);
    EXPECT_NEAR(static_cast<double>(fast.contacts) / static_cast<double>(exact.contacts), 1, 0.01);
    EXPECT_NE(fast.hash, exact.hash); // it is another path
}

TEST(FastMode, FollowsTheReferenceModeToSinglePrecisionWhileTheyAreClose) {
    World exact = test::reference_packing("packing500"), fast = exact;
    StepCaches exact_caches, fast_caches;
    const Mat3 stress = advance(exact, exact_caches, shearing(Mode::Reference), 100).stress;
    const Mat3 fast_stress = advance(fast, fast_caches, shearing(Mode::Fast), 100).stress;
    for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR(fast_stress(a, a) / stress(a, a), 1, 1e-6);
    }
    for (std::size_t g = 0; g < exact.grains.size(); ++g) {
        ASSERT_LE(norm(fast.grains.position[g] - exact.grains.position[g]), 1e-8 * exact.grains.radius[g]) << g;
    }
}

TEST(FastMode, GivesTheSameBitsForAnyThreadsAndHoweverTheStepsAreCut) {
    const auto hash = [](int threads, int bursts) {
        set_thread_count(threads);
        World world = test::reference_packing("packing2000");
        StepCaches caches;
        for (int k = 0; k < bursts; ++k) {
            advance(world, caches, shearing(Mode::Fast), 240 / bursts);
        }
        set_thread_count(1);
        return state_hash(world);
    };
    const std::uint64_t one = hash(1, 1);
    EXPECT_EQ(hash(2, 1), one);
    EXPECT_EQ(hash(1, 240), one); // as after a stop and a resume
    EXPECT_EQ(hash(3, 12), one);
}

/// 68,921 grains, so many that they are lent to a burst; each begins with a velocity of its own.
World large_sample() {
    World world = test::lattice_world(test::simple_cubic, 41, {});
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        const auto k = static_cast<double>(g);
        world.grains.velocity[g] = {0.01 * std::sin(k), 0.01 * std::sin(2 * k), 0.01 * std::sin(3 * k)};
    }
    return world;
}

TEST(FastMode, GivesTheGrainsOfALargeSampleBackAfterEveryBurst) {
    StepPlan plan = shearing(Mode::Fast);
    World cut = large_sample(), whole = cut;
    StepCaches cut_caches, caches;
    advance(cut, cut_caches, plan, 3);
    EXPECT_GT(norm(cut.grains.force[1000]), 0);
    EXPECT_GT(measure_equilibrium(cut).contacts, 0);
    advance(cut, cut_caches, plan, 5);
    advance(whole, caches, plan, 8);
    EXPECT_EQ(state_hash(cut), state_hash(whole));
    plan.mode = Mode::Reference;
    EXPECT_NO_THROW(advance(cut, cut_caches, plan, 1)); // which looks at the same caches
}

TEST(FastMode, LeavesAWholeTableOfASampleThatBlewUp) {
    for (World world : {test::reference_packing("packing500"), large_sample()}) {
        StepCaches caches;
        StepPlan plan = shearing(Mode::Fast);
        plan.dt = 1e-3;
        EXPECT_THROW(advance(world, caches, plan, 1000), Error); // whichever comes first
        EXPECT_EQ(world.grains.position.size(), world.grains.size());
        EXPECT_EQ(world.grains.torque.size(), world.grains.size());
        EXPECT_EQ(world.contacts.overlap.size(), world.contacts.size());
    }
}

TEST(FastMode, ReachesAnUnbalancedForceFarBelowWhatABalanceRequires) {
    World world = test::reference_packing("packing500");
    StepCaches caches;
    StepPlan plan = shearing(Mode::Fast);
    plan.loading = isotropic_stress(100e3);
    advance(world, caches, plan, 1000);
    plan.loading = constant_volume();
    plan.drag = 2e5;
    advance(world, caches, plan, 4000);
    EXPECT_LT(measure_equilibrium(world).unbalanced_force, 1e-5);
}

} // namespace
} // namespace suffuse::dem
