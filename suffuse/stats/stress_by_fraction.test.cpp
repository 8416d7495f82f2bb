#include "suffuse/stats/stress_by_fraction.hpp"

#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::stats {
namespace {

double largest(const Mat3& m) {
    double most = 0;
    for (const auto& row : m.m) {
        for (const double v : row) {
            most = std::max(most, std::abs(v));
        }
    }
    return most;
}

dem::World loaded_packing() {
    dem::World world = test::reference_packing("packing500");
    test::split_at(world, 0.21e-3);
    dem::StepCaches caches;
    test::advance(world, caches, test::plan_of(4e-8, 0.2), 200); // shear forces and moments build up
    return world;
}

TEST(StressByFraction, GrainStressesTimesVolumesAddUpToTheStressOfTheCell) {
    const dem::World world = loaded_packing();
    const std::vector<Mat3> stress = grain_stresses(world);
    Mat3 sum{};
    for (std::size_t g = 0; g < stress.size(); ++g) {
        sum += sphere_volume(world.grains.radius[g]) * stress[g];
    }
    const Mat3 expected = cell::volume(world.cell) * dem::mean_stress_tensor(world);
    EXPECT_GT(dem::mean_stress(dem::mean_stress_tensor(world)), 9e4); // it is the loaded packing
    EXPECT_LE(largest(sum - expected), 1e-12 * largest(expected));    // an identity: rounding of 800 terms
}

TEST(StressByFraction, PartsAddUpAndAlphasWeightedByContentsGiveOne) {
    const StressByFraction s = measure_stress_by_fraction(loaded_packing());
    EXPECT_LE(largest(s.coarse + s.fines - s.total), 1e-12 * largest(s.total));
    EXPECT_GT(s.fines_content, 0.1);
    EXPECT_LT(s.fines_content, 0.9);
    EXPECT_NEAR(s.fines_content * s.alpha_fines + (1 - s.fines_content) * s.alpha_coarse, 1, 1e-12);
}

TEST(StressByFraction, AGrainSqueezedByTwoNeighborsCarriesForceTimesLengthOverVolume) {
    grains::Material material;
    dem::World world = test::empty_world(20, material);
    test::add(world, {4, 5, 5}, 1);
    test::add(world, {5.99, 5, 5}, 1, true);
    test::add(world, {7.98, 5, 5}, 1);
    test::add_contact(world, 0, 1);
    test::add_contact(world, 1, 2);
    const double force = material.modulus * 0.01; // kn = E r
    const std::vector<Mat3> stress = grain_stresses(world);
    // Forces at the two contact points, 1.99 apart. Rounding of 5.99 - 4 - 2 is 1e-14 of the overlap.
    EXPECT_NEAR(stress[1](0, 0) / (force * 1.99 / sphere_volume(1)), 1, 1e-12);
    EXPECT_EQ(stress[1](1, 1), 0);
    EXPECT_NEAR(stress[0](0, 0) / stress[1](0, 0), 0.5, 1e-12); // one contact only
    const StressByFraction s = measure_stress_by_fraction(world);
    EXPECT_NEAR(s.fines_share, 0.5, 1e-12);
    EXPECT_NEAR(s.alpha_fines, 1.5, 1e-12); // half of the stress in a third of the solid
    EXPECT_NEAR(s.alpha_coarse, 0.75, 1e-12);
}

TEST(StressByFraction, ContactPointLiesInTheOverlapWhereRadiiDiffer) {
    dem::World world = test::empty_world(20);
    test::add(world, {4, 5, 5}, 2);
    test::add(world, {6.9, 5, 5}, 1, true);
    test::add_contact(world, 0, 1);
    const std::vector<Mat3> moment = grain_stress_moments(world);
    EXPECT_NEAR(moment[0](0, 0) / moment[1](0, 0), 1.95 / 0.95, 1e-12);
}

TEST(StressByFraction, WithoutContactsIsZeroAndNotNan) {
    dem::World world = test::empty_world(10);
    test::add(world, {1, 1, 1}, 1);
    const StressByFraction s = measure_stress_by_fraction(world);
    EXPECT_EQ(s.fines_share, 0);
    EXPECT_EQ(s.alpha_fines, 0);
}

} // namespace
} // namespace suffuse::stats
