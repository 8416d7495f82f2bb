#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>

namespace suffuse::dem {
namespace {

TEST(ContactsAtLimit, AreThoseWhoseShearForceOrMomentIsAllThatTheNormalForceAllows) {
    World world = test::two_grains(1e-3, 2e-3, 1e-5, {});
    test::add_contact(world, 0, 1);
    const double push = 2 * world.material.modulus * 1e-3 * 2e-3 / 3e-3 * 1e-5;
    const double slip = std::tan(world.material.friction) * push;
    const double roll = world.material.rolling_friction * 1e-3 * push;
    const auto found = [&](double shear, double bending) {
        world.contacts.shear_force.set(0, {0, 0.6 * shear, 0.8 * shear});
        world.contacts.bending.set(0, {0, 0.8 * bending, 0.6 * bending});
        const ContactsAtLimit limits = find_contacts_at_limit(world);
        return std::pair{limits.sliding.at(0) == 1, limits.rolling.at(0) == 1};
    };
    EXPECT_EQ(found(slip, 0.999 * roll), std::pair(true, false));
    EXPECT_EQ(found(0.999 * slip, roll), std::pair(false, true));
    world.contacts.bonded = {1}; // a bond bears shear forces beyond friction until it breaks
    EXPECT_EQ(found(2 * slip, 0), std::pair(false, false));
    world.contacts.bonded.clear();
    world.material.rolling_friction = -1; // no limit
    EXPECT_EQ(found(0, 10 * roll), std::pair(false, false));
    world.material.friction = 0;
    EXPECT_EQ(found(0, 0), std::pair(false, false));
}

TEST(ContactsAtLimit, OfASampleThatIsShearedKeepTheLawToRoundingInBothModes) {
    for (const Mode mode : {Mode::Reference, Mode::Fast}) {
        World world = test::reference_packing("packing500");
        StepCaches caches;
        StepPlan plan = test::plan_of(4e-8, 0.2);
        plan.mode = mode;
        plan.loading.velocity_gradient = diagonal({50, 50, -100});
        advance(world, caches, plan, 500);
        const std::vector<ContactView> views = inspect_contacts(world);
        const ContactsAtLimit limits = find_contacts_at_limit(world);
        ASSERT_EQ(limits.sliding.size(), views.size());
        for (std::size_t c = 0; c < views.size(); ++c) {
            const auto& [i, j, image, overlap, normal, normal_force, shear_force, moment, bonded] = views[c];
            const double push = norm(normal_force), smaller = std::min(world.grains.radius[i], world.grains.radius[j]);
            const double slip = norm(shear_force) / (std::tan(world.material.friction) * push);
            const double roll = norm(moment) / (world.material.rolling_friction * smaller * push);
            EXPECT_LE(std::max(slip, roll), 1 + 1e-6); // single precision
            EXPECT_EQ(limits.sliding[c] == 1, !bonded && slip >= 1 - 1e-6);
            EXPECT_EQ(limits.rolling[c] == 1, roll >= 1 - 1e-6);
        }
        for (const auto& claims : {limits.sliding, limits.rolling}) {
            const auto share = static_cast<double>(std::ranges::count(claims, 1)) / static_cast<double>(views.size());
            EXPECT_NEAR(share, 0.5, 0.4);
        }
    }
}

} // namespace
} // namespace suffuse::dem
