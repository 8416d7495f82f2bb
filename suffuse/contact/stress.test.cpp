#include "suffuse/contact/stress.hpp"

#include <gtest/gtest.h>

namespace suffuse::contact {
namespace {

TEST(AffineModuli, OfOneContactAreThoseOfTheAxesThatItLiesBetween) {
    grains::Grains grains;
    add_grain(grains, {}, 1, 1);
    add_grain(grains, {}, 1, 1);
    grains::Material material;
    material.shear_ratio = 0;
    Contacts contacts;
    contacts.first = {0};
    contacts.second = {1};
    contacts.normal.push_back({0.6, 0, 0.8});
    contacts.overlap = {0};
    const double kn = normal_stiffness(material, 1, 1, 0);
    const AffineModuli moduli = affine_moduli(grains, contacts, material, diagonal({2, 2, 2}));
    EXPECT_NEAR(moduli.shear.y, kn * 4 * 0.36 * 0.64 / 8, 1e-12 * kn); // zx
    EXPECT_EQ(moduli.shear.x, 0);
    EXPECT_EQ(moduli.shear.z, 0);
    EXPECT_EQ(moduli.longitudinal.y, 0);
}

} // namespace
} // namespace suffuse::contact
