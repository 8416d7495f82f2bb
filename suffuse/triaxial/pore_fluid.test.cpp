// Water that gives way in undrained tests: against Skempton's B in closed form.

#include "suffuse/triaxial/pore_fluid.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/triaxial/run_path.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/worlds.hpp"
#include <cmath>
#include <string>

namespace suffuse::triaxial {
namespace {

constexpr double damping_of_water = 0.2;

/// Face-centered spheres at 100 kPa that neither slip nor come apart.
dem::World bonded_lattice() {
    grains::Material bonded;
    bonded.adhesion_normal = bonded.adhesion_shear = 1e12;
    dem::World world = test::lattice_world(test::face_centered, 2, bonded);
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(dem::stable_time_step(world, {damping_of_water}), damping_of_water);
    plan.loading = dem::isotropic_stress(1e5);
    dem::settle(world, caches, plan, {}, 400'000);
    return world;
}

double bulk_modulus_of(const dem::World& world) {
    const test::ElasticConstants c = test::elastic_constants(test::face_centered, world.material);
    return (c.c11 + 2 * c.c12) / 3;
}

TEST(PoreFluid, SharesAnIsotropicLoadWithTheSkeleton) {
    EXPECT_DOUBLE_EQ(skempton_b(0.4, {.bulk_modulus = 0.4e8, .skeleton_modulus = 1e8}), 0.5);
    EXPECT_NEAR(skempton_b(0.4, {.bulk_modulus = 2.2e9, .skeleton_modulus = 1e8}), 0.982, 1e-3);
    EXPECT_NEAR(skempton_b(0.4, {.bulk_modulus = 1e6, .skeleton_modulus = 1e8}), 1 / 41.0, 1e-12);
}

TEST(PoreFluid, TheSkeletonOfALatticeHasTheBulkModulusOfItsBonds) {
    const dem::World world = bonded_lattice();
    EXPECT_NEAR(measure_skeleton_modulus(world, damping_of_water, {}) / bulk_modulus_of(world), 1, 0.01);
}

// An elastic body of cubic symmetry changes its volume with its mean stress alone: K dv = q/3 - u, and u = K_f dv/n.
TEST(PoreFluid, OfAnElasticSampleBearsAThirdOfTheDeviatorStressTimesB) {
    for (const double stiffness : {0.2, 1.0, 20.0}) { // of the fluid over n K
        dem::World world = bonded_lattice();
        const double skeleton = bulk_modulus_of(world), porosity = dem::porosity(world);
        const PoreFluid fluid{stiffness * porosity * skeleton, skeleton};
        TriaxialSpec spec;
        spec.path = Path::Undrained;
        spec.strain = 5e-4;
        spec.rows = 20;
        spec.inertial_number = 1e-5; // some hundred bursts: the volume is one behind the pressure
        PathState state = begin_path(world, spec, dem::mean_stress_tensor(world), fluid);
        dem::StepCaches caches;
        while (!path_burst(world, caches, spec, {}, damping_of_water, dem::Mode::Reference, state)) {
        }
        const double b = skempton_b(porosity, fluid);
        EXPECT_DOUBLE_EQ(state.skempton_b, b);
        const PathRow &first = state.rows.front(), &last = state.rows.back();
        // Second order in the strain, and the burst of delay.
        EXPECT_NEAR(last.excess_pore_pressure / (last.deviator_stress - first.deviator_stress), b / 3, 0.02 * b / 3);
        EXPECT_NEAR(last.volumetric_strain, last.excess_pore_pressure * porosity / fluid.bulk_modulus, 0.02 * 5e-4);
    }
}

TEST(PoreFluid, OfASampleWithoutAStiffnessSaysWhatAnUndrainedTestCanDo) {
    dem::World world = test::two_grains(1e-4, 1e-4, 1e-6, {}); // they fly apart
    test::add_contact(world, 0, 1);
    try {
        measure_skeleton_modulus(world, damping_of_water, {});
        FAIL();
    } catch (const StateError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("the sample is not at rest"), std::string::npos) << text;
        EXPECT_NE(text.find("leave out `bulk_modulus`"), std::string::npos) << text;
        EXPECT_EQ(text.find("raise"), std::string::npos) << text;
    }
}

TEST(PoreFluid, IncompressibleWaterHoldsTheVolume) {
    dem::World world = bonded_lattice();
    TriaxialSpec spec;
    spec.path = Path::Undrained;
    spec.strain = 5e-4;
    const PathState state = begin_path(world, spec, dem::mean_stress_tensor(world));
    EXPECT_EQ(state.storage, 0);
    EXPECT_EQ(state.skempton_b, 1);
}

} // namespace
} // namespace suffuse::triaxial
