#include "suffuse/grains/material.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::grains {
namespace {

Material glass() {
    Material material;
    material.law = ContactLaw::HertzMindlin;
    material.modulus = 70e9;
    return material;
}

// Twice the force squared, twice the force: overlap as force^(2/3); and Hertz's force at that overlap is the force.
TEST(Material, OverlapUnderAForceIsHertzs) {
    const double radius = 1e-4, force = 1e-3, overlap = radius * overlap_under(glass(), force / (radius * radius));
    const double contact_modulus = 70e9 / (2 * (1 - 0.09));
    const double closed = 4.0 / 3 * contact_modulus * std::sqrt(radius / 2) * std::pow(overlap, 1.5);
    EXPECT_NEAR(closed / force, 1, 1e-12);
    EXPECT_NEAR(overlap_under({}, 356e3), 1e-3, 1e-15);
}

TEST(Material, LinearizedIsAsStiffAsHertzAtThatOverlap) {
    const Material linear = linearized(glass(), 1e-3);
    const double radius = 1e-4, overlap = 1e-3 * radius;
    const double tangent = 1.5 * hertz_modulus(glass()) * std::sqrt(radius / 2 * overlap);
    EXPECT_NEAR(linear.modulus * radius / tangent, 1, 1e-12); // kn = E r of equal grains
    EXPECT_NEAR(linear.shear_ratio, 2 * 0.7 / 1.7, 1e-15);
    EXPECT_EQ(linearized({}, 1e-3).modulus, Material{}.modulus);
}

} // namespace
} // namespace suffuse::grains
