// Elastic constants of regular packings, measured through the periodic cell; contacts that may pull (here: bonded).

#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/worlds.hpp"
#include <string>

namespace suffuse::dem {
namespace {

using test::body_centered;
using test::face_centered;
using test::Lattice;
using test::simple_cubic;

constexpr double radius = test::lattice_radius, diameter = 2 * radius; // [m]
constexpr double strain_size = 1e-6;

grains::Material bonded() {
    grains::Material material;
    material.adhesion_normal = material.adhesion_shear = 1e12; // no contact opens or slips
    return material;
}

World build(const Lattice& lattice, int repeat) {
    return test::lattice_world(lattice, repeat, bonded());
}

struct Response {
    Mat3 strain, stress; ///< extension and tension positive
};

/// Deforms the lattice at the rate `direction` [1/s] until the strain is `strain_size`, in ten steps.
Response deform(World world, const Mat3& direction) {
    StepCaches caches;
    StepPlan plan = test::plan_of(strain_size / 10);
    const Mat3 start = step(world, caches, plan).stress; // contacts begin
    plan.loading.velocity_gradient = direction;
    Mat3 stress;
    for (int k = 0; k < 10; ++k) {
        stress = step(world, caches, plan).stress;
    }
    const Mat3 stretch = world.cell.h * inverse(world.reference_h) - identity();
    return {0.5 * (stretch + transpose(stretch)), start - stress};
}

class LatticeElasticity : public testing::TestWithParam<std::pair<Lattice, int>> {};

TEST_P(LatticeElasticity, MeetsTheSumsOverBonds) {
    const auto& [lattice, repeat] = GetParam();
    const World world = build(lattice, repeat);
    const test::ElasticConstants want = test::elastic_constants(lattice, world.material);

    const Response axial = deform(world, diagonal({1, 0, 0}));
    ASSERT_NEAR(axial.strain(0, 0), strain_size, 0.2 * strain_size);
    const double c11 = axial.stress(0, 0) / axial.strain(0, 0), c12 = axial.stress(1, 1) / axial.strain(0, 0);
    const Response shear = deform(world, {{{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}}}});
    const double c44 = 0.5 * shear.stress(0, 1) / shear.strain(0, 1);

    // Second order in the strain, below 1e-6; overlaps are differences of lengths, 1e-16/1e-7 of them.
    const double tolerance = 1e-6 * want.c11;
    EXPECT_NEAR(c11, want.c11, tolerance);
    EXPECT_NEAR(c12, want.c12, tolerance);
    EXPECT_NEAR(axial.stress(2, 2) / axial.strain(0, 0), want.c12, tolerance);
    EXPECT_NEAR(c44, want.c44, tolerance);
    EXPECT_NEAR(axial.stress(0, 1) / strain_size, 0, tolerance);
    RecordProperty("c11_error", std::to_string(1e6 * (c11 / want.c11 - 1)) + "e-6");
    RecordProperty("c12_error", std::to_string(1e6 * (c12 - want.c12) / want.c11) + "e-6");
    RecordProperty("c44_error", std::to_string(1e6 * (c44 / want.c44 - 1)) + "e-6");
}

INSTANTIATE_TEST_SUITE_P(
    Cubic, LatticeElasticity,
    testing::Values(
        std::pair{simple_cubic, 1}, std::pair{simple_cubic, 3}, std::pair{body_centered, 2},
        std::pair{face_centered, 1}, std::pair{face_centered, 2}
    ),
    [](const auto& test) { return test.param.first.name + std::to_string(test.param.second); }
);

TEST(Lattice, HasTheModuliThatTheServoUses) { // its grains move with the mean strain, by symmetry
    for (const Lattice& lattice : {simple_cubic, body_centered, face_centered}) {
        World world = build(lattice, 2);
        StepCaches caches;
        step(world, caches, test::plan_of(1e-9));
        const test::ElasticConstants want = test::elastic_constants(lattice, world.material);
        const auto moduli = contact::affine_moduli(world.grains, world.contacts, world.material, world.cell.h);
        for (int a = 0; a < 3; ++a) { // overlaps are 1e-10 of the diameter
            EXPECT_NEAR(moduli.longitudinal[a] / want.c11, 1, 1e-8) << lattice.name;
            EXPECT_NEAR(moduli.shear[a] / want.c44, 1, 1e-8) << lattice.name;
        }
    }
}

TEST(Lattice, HasItsCoordinationEvenInACellAsNarrowAsOneGrain) {
    for (const Lattice& lattice : {simple_cubic, body_centered, face_centered}) {
        for (const int repeat : {1, 2}) {
            World world = build(lattice, repeat);
            StepCaches caches;
            step(world, caches, test::plan_of(1e-8));
            for (const int contacts : coordination(world)) {
                EXPECT_EQ(contacts, lattice.coordination) << lattice.name << repeat;
            }
        }
    }
}

TEST(Lattice, BulkModulusOfFaceCenteredIsItsNormalStiffnessOverTheDiameter) {
    const World world = build(face_centered, 2);
    const Response squeezed = deform(world, diagonal({-1, -1, -1}));
    const double bulk = trace(squeezed.stress) / 3 / trace(squeezed.strain);
    const double kn = world.material.modulus * radius;
    EXPECT_NEAR(bulk / (2 * std::sqrt(2.0) * kn / (3 * diameter)), 1, 3e-6); // second order in the strain
}

TEST(Lattice, IsAtRestUnderItsOwnSymmetry) {
    World world = build(face_centered, 2);
    StepCaches caches;
    StepPlan plan = test::plan_of(1e-8);
    plan.loading.velocity_gradient = diagonal({-10, -10, -10});
    test::advance(world, caches, plan, 1000);
    const double pressure = mean_stress(mean_stress_tensor(world));
    EXPECT_GT(pressure, 1e4);
    for (const Vec3& force : world.grains.force) { // sums of twelve equal forces
        EXPECT_LE(norm(force), 1e-9 * pressure * radius * radius);
    }
}

} // namespace
} // namespace suffuse::dem
