#include "suffuse/dem/first_contacts.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/step.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

World packing_with_first_contacts() {
    World world = test::reference_packing("packing500");
    add_first_contacts(world);
    return world;
}

TEST(FirstContacts, AreThoseThatTheFirstStepFinds) {
    const World first = packing_with_first_contacts();
    World stepped = test::reference_packing("packing500");
    StepCaches caches;
    step(stepped, caches, test::plan_of(1e-15)); // nothing moves by more than rounding
    const std::vector<ContactView> found = inspect_contacts(first), made = inspect_contacts(stepped);
    ASSERT_GT(found.size(), 500U);
    ASSERT_EQ(found.size(), made.size());
    for (std::size_t c = 0; c < found.size(); ++c) {
        EXPECT_EQ(found[c].i, made[c].i);
        EXPECT_EQ(found[c].j, made[c].j);
        EXPECT_NEAR(found[c].overlap, made[c].overlap, 1e-15); // of positions near 1e-3: rounding
        EXPECT_LT(norm(found[c].normal_force - made[c].normal_force), 1e-9 * norm(made[c].normal_force) + 1e-12);
        EXPECT_EQ(found[c].shear_force, Vec3{});
    }
    const Equilibrium before = measure_equilibrium(first), after = measure_equilibrium(stepped);
    EXPECT_EQ(before.rattlers, after.rattlers);
    EXPECT_NEAR(before.unbalanced_force, after.unbalanced_force, 1e-6 * after.unbalanced_force); // as above
    EXPECT_NEAR(trace(mean_stress_tensor(first)), trace(mean_stress_tensor(stepped)), 1e-6 * 3e5);
}

TEST(FirstContacts, ChangeNoBitOfWhatFollows) {
    for (const double adhesion : {0.0, 1e4}) {
        World plain = test::reference_packing("packing500");
        World seen = packing_with_first_contacts();
        EXPECT_EQ(state_hash(plain), state_hash(seen)) << "of what the next step depends on";
        for (World* world : {&plain, &seen}) {
            world->material.adhesion_normal = world->material.adhesion_shear = adhesion; // after the look
            const double dt = stable_time_step(*world);
            StepCaches caches;
            advance(*world, caches, test::plan_of(dt, 0.2), 50);
        }
        EXPECT_EQ(state_hash(plain), state_hash(seen));
    }
}

TEST(FirstContacts, GrainsInOnePlaceHaveANormalToo) {
    World world = test::empty_world(1e-2);
    test::add(world, {5e-3, 5e-3, 5e-3}, 1e-3);
    test::add(world, {5e-3, 5e-3, 5e-3}, 1e-3);
    EXPECT_EQ(find_first_contacts(world).normal[0], (Vec3{1, 0, 0}));
    EXPECT_EQ(find_first_contacts(world).overlap[0], 2e-3);
}

} // namespace
} // namespace suffuse::dem
