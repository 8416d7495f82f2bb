// Small-strain stiffness: against the elastic constants of lattices, and under the mean-field bound in random packings.

#include "suffuse/triaxial/stiffness.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/contact/stress.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/worlds.hpp"
#include <cmath>

namespace suffuse::triaxial {
namespace {

constexpr double damping = 0.2;

Stiffness measure(const dem::World& world, const StiffnessSpec& spec) {
    RestedState state = rest_for_strains(world, spec, damping, {});
    std::vector<StrainProbe> probes;
    for (int number = 0; number < strain_directions; ++number) {
        probes.push_back(probe_strain(state, spec, strain_direction(number), damping, {}));
    }
    return stiffness_of(state, probes);
}

grains::Material linear() {
    return {};
}

grains::Material hertzian() {
    grains::Material material;
    material.law = grains::ContactLaw::HertzMindlin;
    material.modulus = 70e9;
    material.poisson = 0.25;
    return material;
}

struct LatticeCase {
    test::Lattice lattice;
    grains::Material material;
    double strain; ///< along each axis, before the probes
};

/// Squeezed alike along all axes.
dem::World squeezed(const LatticeCase& of) {
    dem::World world = test::lattice_world(of.lattice, 2, of.material);
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(1e-9);
    plan.loading.velocity_gradient = diagonal({-1, -1, -1});
    test::advance(world, caches, plan, static_cast<int>(std::lround(of.strain / plan.dt)));
    return world;
}

class LatticeStiffness : public testing::TestWithParam<LatticeCase> {};

TEST_P(LatticeStiffness, IsTheSumOverItsBonds) {
    const LatticeCase& of = GetParam();
    const dem::World world = squeezed(of);
    const double overlap = 2 * test::lattice_radius * of.strain;
    const double kn = contact::normal_stiffness(of.material, test::lattice_radius, test::lattice_radius, overlap);
    const double ks = contact::spring_of(of.material).shear_ratio(of.material) * kn;
    const test::ElasticConstants want = test::elastic_constants(of.lattice, kn, ks);
    StiffnessSpec spec;
    spec.increment = 1e-3 * of.strain;
    spec.unbalanced_force = 1e-9;
    const Stiffness found = measure(world, spec);
    // The squeezed lattice is smaller, and its stress adds to the moduli: both by a few of its strains. A Hertzian
    // contact stiffens by half of the increment over its strain.
    const double tolerance = (10 * of.strain + 1e-3) * want.c11;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            const double wanted = i == j ? (i < 3 ? want.c11 : want.c44) : i < 3 && j < 3 ? want.c12 : 0;
            EXPECT_NEAR(found.tensor[i][j], wanted, tolerance) << i << j;
        }
    }
    EXPECT_LE(found.nonlinearity, elastic_within);
    EXPECT_NEAR(found.bulk_modulus, (want.c11 + 2 * want.c12) / 3, tolerance);
    EXPECT_NEAR(found.mean_field_bulk, found.bulk_modulus, tolerance); // grains move with the mean strain
    EXPECT_NEAR(found.mean_field_shear, found.shear_modulus, tolerance);
    const double zener = 2 * want.c44 / (want.c11 - want.c12);
    EXPECT_NEAR(*found.anisotropy, 1.2 * std::pow(std::sqrt(zener) - 1 / std::sqrt(zener), 2), 0.03);
}

INSTANTIATE_TEST_SUITE_P(
    Cubic, LatticeStiffness,
    testing::Values(
        LatticeCase{test::simple_cubic, linear(), 1e-5}, LatticeCase{test::body_centered, linear(), 1e-5},
        LatticeCase{test::face_centered, linear(), 1e-5}, LatticeCase{test::simple_cubic, hertzian(), 1e-4},
        LatticeCase{test::body_centered, hertzian(), 1e-4}, LatticeCase{test::face_centered, hertzian(), 1e-4}
    ),
    [](const auto& test) {
        return test.param.lattice.name +
               (test.param.material.law == grains::ContactLaw::HertzMindlin ? "Hertz" : "Linear");
    }
);

dem::World settled_sample() {
    dem::World world = test::reference_packing("packing500");
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(4e-8, damping);
    plan.loading = dem::isotropic_stress(1e5);
    dem::settle(world, caches, plan, {}, 200'000);
    return world;
}

TEST(Stiffness, OfARandomPackingIsBelowTheMeanFieldAndNotFarBelow) {
    const Stiffness found = measure(settled_sample(), {});
    EXPECT_LT(found.bulk_modulus, found.mean_field_bulk);
    EXPECT_LT(found.shear_modulus, found.mean_field_shear);
    EXPECT_GT(found.bulk_modulus, 0.7 * found.mean_field_bulk); // measured: 0.84 and 0.79 of it
    EXPECT_GT(found.shear_modulus, 0.6 * found.mean_field_shear);
    EXPECT_LE(found.nonlinearity, 1e-3);
    EXPECT_LE(found.reciprocity, 2e-3); // a prestressed body's tensor is symmetric but for its stress over its modulus
    EXPECT_LT(*found.anisotropy, 0.05); // 500 grains under isotropic stress
}

TEST(Stiffness, FallsWithTheStrainBeyondTheElasticRange) {
    const dem::World world = settled_sample();
    StiffnessSpec large;
    large.increment = 1e-3;
    const Stiffness elastic = measure(world, {}), yielding = measure(world, large);
    EXPECT_GT(yielding.nonlinearity, elastic_within);
    EXPECT_LT(yielding.shear_modulus, 0.95 * elastic.shear_modulus);
}

TEST(Stiffness, DoesNotDependOnTheIncrementWithinTheElasticRange) {
    const dem::World world = settled_sample();
    StiffnessSpec large;
    large.increment = 1e-5;
    const Stiffness small = measure(world, {}), found = measure(world, large);
    EXPECT_NEAR(found.shear_modulus, small.shear_modulus, 2e-3 * small.shear_modulus);
    EXPECT_NEAR(found.bulk_modulus, small.bulk_modulus, 2e-3 * small.bulk_modulus);
}

// A blow that dies away within some bursts: what the twin bears of it is no answer to the strain.
TEST(Stiffness, OfASampleThatStillCreepsIsThatOfOneAtRest) {
    dem::World world = settled_sample();
    dem::StepCaches caches;
    dem::StepPlan blow = test::plan_of(4e-8, damping);
    blow.loading.velocity_gradient = diagonal({-20, 10, 10});
    test::advance(world, caches, blow, 50);
    StiffnessSpec rested, restless;
    rested.unbalanced_force = 1e-7;
    restless.unbalanced_force = 0.1;
    const Stiffness want = measure(world, rested), found = measure(world, restless);
    EXPECT_NEAR(found.shear_modulus, want.shear_modulus, 1e-3 * want.shear_modulus);
    EXPECT_NEAR(found.bulk_modulus, want.bulk_modulus, 1e-3 * want.bulk_modulus);
}

TEST(Stiffness, NeedsASampleThatCarriesAStressAndRests) {
    const dem::World apart = test::two_grains(1e-4, 1e-4, -1e-6, {});
    EXPECT_THROW((void)rest_for_strains(apart, {}, damping, {}), StateError);
    StiffnessSpec hasty;
    hasty.unbalanced_force = 1e-14;
    hasty.max_steps = 100;
    EXPECT_THROW((void)rest_for_strains(settled_sample(), hasty, damping, {}), StateError);
}

} // namespace
} // namespace suffuse::triaxial
