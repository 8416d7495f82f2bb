#include "suffuse/dem/given_contacts.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/step.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

/// A sheared packing, in the middle of its motion.
World sheared_packing() {
    World world = test::reference_packing("packing500");
    world.material.twisting_stiffness = 1, world.material.twisting_friction = 0.1;
    StepCaches caches;
    StepPlan plan = test::plan_of(stable_time_step(world), 0.2);
    plan.loading.velocity_gradient = diagonal({20, 20, -50}); // [1/s]
    advance(world, caches, plan, 200);
    return world;
}

/// The same grains as a file has them, without memory.
World without_memory(const World& world) {
    World plain;
    plain.cell = world.cell;
    plain.reference_h = world.reference_h;
    plain.material = world.material;
    plain.grains = world.grains;
    return plain;
}

std::vector<GivenContact> contacts_of(const World& world) {
    std::vector<GivenContact> given;
    for (const ContactView& view : inspect_contacts(world)) {
        given.push_back({view.i, view.j, view.shear_force, view.moment});
    }
    return given;
}

TEST(GivenContacts, AWorldThatIsHandedOverGoesOnAsIfItWereNot) {
    World own = sheared_packing(), plain = without_memory(own), handed = without_memory(own);
    const std::vector<GivenContact> given = contacts_of(own);
    const TakenContacts taken = add_given_contacts(handed, given);
    // a step moves grains after it looked at their contacts: a few part or meet
    EXPECT_GT(taken.remembered, 0.99 * static_cast<double>(given.size()));
    EXPECT_EQ(taken.remembered + taken.apart, given.size());
    const double dt = stable_time_step(own);
    for (World* world : {&own, &plain, &handed}) {
        StepCaches caches;
        advance(*world, caches, test::plan_of(dt, 0.2), 100);
    }
    const Mat3 expected = mean_stress_tensor(own), found = mean_stress_tensor(handed), lost = mean_stress_tensor(plain);
    const double scale = trace(expected) / 3;
    const auto difference = [&](const Mat3& a) {
        const Mat3 d = a - expected;
        return (norm(d.row(0)) + norm(d.row(1)) + norm(d.row(2))) / scale;
    };
    EXPECT_LT(difference(found), 1e-3); // memory turns with the contact: half a step is not known
    EXPECT_GT(difference(lost), 20 * difference(found));
}

TEST(GivenContacts, ForcesActOnTheGrainThatIsNamedFirst) {
    World world = test::empty_world(1e-2);
    test::add(world, {5e-3, 5e-3, 5e-3}, 1e-3);
    test::add(world, {6.9e-3, 5e-3, 5e-3}, 1e-3);
    const GivenContact reversed{1, 0, {3, 2, 0}, {4, 5, 0}}; // on the right grain; 3 and 4 act along the normal
    EXPECT_EQ(add_given_contacts(world, {&reversed, 1}).remembered, 1U);
    const ContactView view = inspect_contacts(world).at(0);
    EXPECT_EQ(view.i, 0U);
    EXPECT_EQ(view.shear_force, (Vec3{0, -2, 0}));
    EXPECT_EQ(view.moment, (Vec3{0, -5, 0})) << "this material has no twisting";
    EXPECT_EQ(world.grains.force[1].y, 2);
}

TEST(GivenContacts, ShearForcesThatFrictionDoesNotBearAreNamedWithTheirLine) {
    World own = sheared_packing(), handed = without_memory(own), other = handed;
    std::vector<GivenContact> given = contacts_of(own);
    EXPECT_FALSE(words_on_cut(add_given_contacts(handed, given), "c.csv")) << "as they were handed over";
    int line = 1;
    for (GivenContact& contact : given) {
        contact.shear_force *= 1e3; // mN for N
        contact.line = ++line;
    }
    const TakenContacts taken = add_given_contacts(other, given);
    const std::string words = words_on_cut(taken, "c.csv").value();
    EXPECT_EQ(words.find(fmt::format("c.csv:{}: the shear force of grains", taken.worst.line)), 0U) << words;
    EXPECT_GT(taken.worst.line, 1);
    EXPECT_GT(taken.beyond, taken.remembered / 2);
    EXPECT_LT(taken.worst_limit, 0.01 * taken.worst_cut);
}

TEST(GivenContacts, PairsThatDoNotTouchAndContactsThatNobodyGivesAreCounted) {
    World world = test::empty_world(1e-2);
    for (const double x : {1e-3, 2.9e-3, 6e-3}) {
        test::add(world, {x, 5e-3, 5e-3}, 1e-3);
    }
    const GivenContact far{0, 2, {0, 1, 0}, {}};
    const TakenContacts taken = add_given_contacts(world, {&far, 1});
    EXPECT_EQ(taken.remembered, 0U);
    EXPECT_EQ(taken.unknown, 1U);
    EXPECT_EQ(taken.apart, 1U);
}

TEST(GivenContacts, APairTwiceIsRefused) {
    World world = test::empty_world(3.8e-3); // so narrow that the grains meet on both sides
    test::add(world, {1e-3, 1e-3, 1e-3}, 1e-3);
    test::add(world, {2.9e-3, 1e-3, 1e-3}, 1e-3);
    const std::vector<GivenContact> once{{0, 1, {0, 1, 0}, {}}}, twice{{0, 1, {0, 1, 0}, {}}, {1, 0, {0, 1, 0}, {}}};
    World other = world;
    EXPECT_THROW(add_given_contacts(world, once), CaseError);
    EXPECT_THROW(add_given_contacts(other, twice), CaseError);
}

} // namespace
} // namespace suffuse::dem
