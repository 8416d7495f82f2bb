#include "suffuse/stats/fines.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::stats {
namespace {

/// Two coarse grains that press hard, one fine grain between them (two contacts), one fine grain on its own.
dem::World two_coarse_two_fine() {
    dem::World world = test::empty_world(10);
    test::add(world, {3, 3, 3}, 1);
    test::add(world, {4.9, 3, 3}, 1);
    const double height = std::sqrt(1.495 * 1.495 - 0.95 * 0.95); // overlaps of 0.005 with both
    test::add(world, {3.95, 3 + height, 3}, 0.5, true);
    test::add(world, {8, 8, 8}, 0.5, true);
    test::add_contact(world, 0, 1);
    test::add_contact(world, 0, 2);
    test::add_contact(world, 1, 2);
    return world;
}

TEST(Fines, VoidRatiosOfAHandMadeSampleFollowTheirDefinitions) {
    const FinesState state = measure_fines(two_coarse_two_fine());
    const double solid = 2 * sphere_volume(1) + 2 * sphere_volume(0.5), e = 1000 / solid - 1, fc = 0.25 / 2.25;
    EXPECT_NEAR(state.void_ratio, e, 1e-13 * e);
    EXPECT_NEAR(state.fines_content, fc, 1e-14);
    EXPECT_DOUBLE_EQ(state.active_fraction, 0.5);
    // Voids plus lost solid, over the solid that remains: volumes, not the formulas of the code.
    const double fine_grain = sphere_volume(0.5), coarse = 2 * sphere_volume(1);
    EXPECT_NEAR(state.intergranular_void_ratio, (1000 - coarse) / coarse, 1e-12 * e);
    EXPECT_NEAR(state.equivalent_void_ratio, (1000 - coarse - fine_grain) / (coarse + fine_grain), 1e-12 * e);
}

TEST(Fines, EquivalentVoidRatioGoesFromIntergranularToPlainAsFinesBecomeActive) {
    dem::World world = two_coarse_two_fine();
    contact::Contacts contacts = world.contacts;
    world.contacts.normal.set(2, {}); // one contact fewer: no fine grain is active
    FinesState state = measure_fines(world);
    EXPECT_EQ(state.active_fraction, 0);
    EXPECT_DOUBLE_EQ(state.equivalent_void_ratio, state.intergranular_void_ratio);
    world.contacts = contacts;
    grains::select_rows(world.grains, std::vector<std::uint32_t>{0, 1, 2}); // the idle fine grain leaves
    state = measure_fines(world);
    EXPECT_EQ(state.active_fraction, 1);
    EXPECT_DOUBLE_EQ(state.equivalent_void_ratio, state.void_ratio);
}

TEST(Fines, ContactSharesAndStrongSharesSeparateTheClasses) {
    const FinesState state = measure_fines(two_coarse_two_fine());
    EXPECT_DOUBLE_EQ(state.contact_share.large_large, 1.0 / 3);
    EXPECT_DOUBLE_EQ(state.contact_share.large_small, 2.0 / 3);
    EXPECT_EQ(state.contact_share.small_small, 0);
    // Overlaps 0.1 against 0.005: only the coarse contact is above the mean.
    EXPECT_EQ(state.strong_contact_share.large_large, 1);
    EXPECT_EQ(state.strong_contact_share.large_small, 0);
}

TEST(Fines, ShearCountsInWhatMakesAContactStrong) {
    dem::World world = two_coarse_two_fine();
    const double hard = 2 * world.material.modulus; // [N], beyond the normal force of any contact here
    world.contacts.shear_force.set(1, {0, 0, hard});
    EXPECT_GT(measure_fines(world).strong_contact_share.large_small, 0.4);
}

TEST(Fines, AContactIsStrongThatCarriesMoreThanTheMean) {
    // Of forces 0.1, 0.0033 and that with shear, over the modulus: the mean is 0.045, then 0.055.
    for (const auto& [shear, share] : {std::pair{0.035, 0.0}, std::pair{0.060, 0.5}}) {
        dem::World world = two_coarse_two_fine();
        world.contacts.shear_force.set(1, {0, 0, shear * world.material.modulus});
        EXPECT_DOUBLE_EQ(measure_fines(world).strong_contact_share.large_small, share) << shear;
    }
}

TEST(Fines, CoarseSoilHasOneVoidRatioAndFineSoilNoSkeleton) {
    dem::World world = two_coarse_two_fine();
    std::fill(world.grains.fine.begin(), world.grains.fine.end(), std::uint8_t{0});
    FinesState state = measure_fines(world);
    EXPECT_EQ(state.fines_content, 0);
    EXPECT_EQ(state.intergranular_void_ratio, state.void_ratio);
    EXPECT_EQ(state.equivalent_void_ratio, state.void_ratio);
    std::fill(world.grains.fine.begin(), world.grains.fine.end(), std::uint8_t{1});
    state = measure_fines(world);
    EXPECT_EQ(state.fines_content, 1);
    EXPECT_TRUE(std::isinf(state.intergranular_void_ratio));
    EXPECT_EQ(state.contact_share.small_small, 1);
}

} // namespace
} // namespace suffuse::stats
