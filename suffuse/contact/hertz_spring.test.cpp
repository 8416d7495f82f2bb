#include "suffuse/contact/hertz_spring.hpp"

#include "suffuse/contact/one_contact.hpp"
#include "suffuse/contact/springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::contact {
namespace {

constexpr double r1 = 1e-4, r2 = 1.5e-4, overlap = 1e-8, dt = 1e-9;

grains::Material glass() {
    grains::Material material;
    material.law = grains::ContactLaw::HertzMindlin;
    material.modulus = 70e9;
    material.poisson = 0.3;
    material.rolling_stiffness = 0;
    material.friction = 1.5; // barely slips
    return material;
}

/// A contact along x whose second grain can be moved.
struct Bench {
    LawConstants law = resolve_law(glass());
    double reach = r1 + r2, gap = -overlap, slid = 0;
    ContactMemory<double> memory{};

    /// One step to another gap and slip [m]. @return force on the second grain
    Triple<double> move(double new_gap, double new_slid) {
        const double factor = reach / (reach + new_gap); // of the law, on the velocity
        const GrainPair<double> pair{
            {reach + new_gap, 0, 0}, {(new_gap - gap) / dt, (new_slid - slid) / (factor * dt), 0}, {}, {}, r1, r2};
        gap = new_gap, slid = new_slid;
        return act_between<false, false>(law, dt, pair, memory).force;
    }
};

// F = (4/3) E* sqrt(R) overlap^(3/2), with E* = E/(2 (1 - nu^2)) of two like grains.
TEST(HertzMindlin, NormalForceIsThatOfElasticSpheres) {
    const double contact_modulus = 70e9 / (2 * (1 - 0.09)), radius = r1 * r2 / (r1 + r2);
    Bench bench;
    const double expected = 4.0 / 3 * contact_modulus * std::sqrt(radius) * std::pow(overlap, 1.5);
    EXPECT_NEAR(bench.move(-overlap, 0).x / expected, 1, 1e-7); // the overlap is a ten thousandth of the distance
    EXPECT_EQ(bench.move(1e-12, 0).x, 0);
}

// dT/ds = 8 G* sqrt(R overlap), with G* = G/(2 (2 - nu)) of two like grains, G = E/(2 (1 + nu)).
TEST(HertzMindlin, ShearStiffnessIsThatOfMindlinWithoutSlip) {
    const double shear_modulus = 70e9 / (2 * 1.3), radius = r1 * r2 / (r1 + r2);
    const double expected = 8 * shear_modulus / (2 * 1.7) * std::sqrt(radius * overlap);
    Bench bench;
    bench.move(-overlap, 0);
    EXPECT_NEAR(bench.move(-overlap, 1e-11).y / (-1e-11 * expected), 1, 1e-6);
}

// [Agnolin and Roux 2007]: T falls with the shear stiffness, sqrt(overlap), and does not rise with it.
TEST(HertzMindlin, PartingTakesTheShearForceOfTheAreaThatIsLost) {
    Bench bench;
    bench.move(-overlap, 0);
    const double sheared = bench.move(-overlap, 1e-10).y;
    constexpr int steps = 10'000;
    double parted = 0, pressed = 0;
    for (int k = 1; k <= steps; ++k) {
        parted = bench.move(-overlap * (1 - 0.75 * k / steps), 1e-10).y;
    }
    EXPECT_NEAR(parted / sheared, 0.5, 1e-6); // a quarter of the overlap is left
    for (int k = 1; k <= steps; ++k) {
        pressed = bench.move(-overlap * (0.25 + 0.75 * k / steps), 1e-10).y;
    }
    EXPECT_NEAR(pressed / parted, 1, 1e-9);
}

TEST(HertzMindlin, ViscousForceIsTheSpecifiedShareOfTheCriticalOne) {
    grains::Material material = glass();
    material.viscous_damping = 0.3;
    const LawConstants law = resolve_law(material);
    const double m1 = material.density * sphere_volume(r1), m2 = material.density * sphere_volume(r2);
    const double mass = m1 * m2 / (m1 + m2), secant = HertzSpring::force(material, r1, r2, overlap) / overlap;
    const double critical = 2 * std::sqrt(mass * 1.5 * secant); // d(F)/d(overlap) is 1.5 F/overlap
    EXPECT_NEAR(viscous_force(law, r1, r2, secant, 0.01) / (-0.3 * critical * 0.01), 1, 1e-12);
    EXPECT_EQ(viscous_force(law, r2, r1, secant, 0.01), viscous_force(law, r1, r2, secant, 0.01));
    EXPECT_EQ(viscous_force(law, r1, r2, 0.0, 0.01), 0); // at the first touch
}

// Twice the force squared, twice the force: overlap as force^(2/3); and Hertz's force at that overlap is the force.
TEST(HertzMindlin, OverlapUnderAForceIsHertzs) {
    const double radius = 1e-4, force = 1e-3;
    const double depth = radius * HertzSpring::overlap_under(glass(), force / (radius * radius));
    const double contact_modulus = 70e9 / (2 * (1 - 0.09));
    const double closed = 4.0 / 3 * contact_modulus * std::sqrt(radius / 2) * std::pow(depth, 1.5);
    EXPECT_NEAR(closed / force, 1, 1e-12);
    EXPECT_NEAR(LinearSpring::overlap_under({}, 356e3), 1e-3, 1e-15);
}

TEST(HertzMindlin, LinearizedIsAsStiffAtThatOverlap) {
    const grains::Material linear = linearized(glass(), 1e-3);
    const double radius = 1e-4, depth = 1e-3 * radius;
    const double tangent = 1.5 * hertz_modulus(glass()) * std::sqrt(radius / 2 * depth);
    EXPECT_NEAR(linear.modulus * radius / tangent, 1, 1e-12); // kn = E r of equal grains
    EXPECT_NEAR(linear.shear_ratio, 2 * 0.7 / 1.7, 1e-15);
    EXPECT_EQ(linearized({}, 1e-3).modulus, grains::Material{}.modulus);
}

} // namespace
} // namespace suffuse::contact
