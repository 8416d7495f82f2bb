// Stress probes: against the elastic constants of a lattice, and on samples that are far from failure and near it.

#include "suffuse/triaxial/stress_probe.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/settle.hpp"
#include "suffuse/triaxial/response.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>

namespace suffuse::triaxial {
namespace {

constexpr double damping = 0.2;

std::vector<StressProbe> probe_all(const ProbedState& state, const StressProbeSpec& spec) {
    std::vector<StressProbe> probes;
    for (int k = 0; k < spec.directions; ++k) {
        probes.push_back(probe_direction(state, spec, k, damping, {}));
    }
    return probes;
}

std::vector<StressProbe> probe_all(const dem::World& world, const StressProbeSpec& spec) {
    return probe_all(rest_for_probes(world, spec, damping, {}), spec);
}

/// A face-centered packing squeezed to some kPa, so that increments open no contact.
dem::World squeezed_lattice() {
    dem::World world = test::lattice_world(test::face_centered, 2, {});
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(1e-8);
    plan.loading.velocity_gradient = diagonal({-1, -1, -1});
    test::advance(world, caches, plan, 1000);
    return world;
}

TEST(StressProbe, AFaceCenteredPackingAnswersWithItsElasticConstants) {
    const dem::World world = squeezed_lattice();
    const test::ElasticConstants c = test::elastic_constants(test::face_centered, world.material);
    StressProbeSpec spec;
    spec.directions = 12;
    spec.unbalanced_force = 1e-9;
    for (spec.axis = 0; spec.axis < 3; ++spec.axis) {
        for (const StressProbe& probe : probe_all(world, spec)) {
            EXPECT_EQ(probe.answer, Answer::Rests);
            const int side = (spec.axis + 1) % 3;
            const double axial = probe.strain[spec.axis], lateral = probe.strain[side];
            const double size = norm(probe.stress);
            // The stress of that strain; the contacts' overlap is 1e-5 of the diameter, second order.
            EXPECT_NEAR(probe.stress[spec.axis], c.c11 * axial + 2 * c.c12 * lateral, 2e-4 * size) << probe.angle;
            EXPECT_NEAR(probe.stress[side], c.c12 * axial + (c.c11 + c.c12) * lateral, 2e-4 * size) << probe.angle;
            EXPECT_NEAR(probe.second_order_work, dot(probe.stress, probe.strain), 1e-12 * probe.second_order_work);
            EXPECT_GT(probe.normalized, 0.5);
        }
    }
}

TEST(StressProbe, AStateMayTakeAllItsStepsToRest) {
    StressProbeSpec spec;
    spec.max_steps = rest_for_probes(squeezed_lattice(), spec, damping, {}).steps;
    EXPECT_EQ(rest_for_probes(squeezed_lattice(), spec, damping, {}).steps, spec.max_steps);
}

TEST(StressProbe, LoadsHaveTheirSizeAndDirection) {
    StressProbeSpec spec;
    spec.directions = 8;
    spec.axis = 1;
    spec.unbalanced_force = 1e-9;
    const ProbedState state = rest_for_probes(squeezed_lattice(), spec, damping, {});
    const double size = spec.increment * (state.stress.x + state.stress.y + state.stress.z) / 3;
    for (const StressProbe& probe : probe_all(state, spec)) {
        const double lateral = std::cos(probe.angle) / std::sqrt(2.0);
        const Vec3 wanted = size * Vec3{lateral, std::sin(probe.angle), lateral};
        EXPECT_LE(norm(probe.stress - wanted), 0.02 * size) << probe.angle;
    }
}

/// 500 grains of the reference at 100 kPa.
dem::World settled_sample() {
    dem::World world = test::reference_packing("packing500");
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(4e-8, damping);
    plan.loading = dem::isotropic_stress(1e5);
    dem::settle(world, caches, plan, {}, 200'000);
    return world;
}

/// Compressed, drained, until it carries this deviator stress; 110 kPa it carries too.
dem::World sheared_sample(double deviator_stress) {
    dem::World world = settled_sample();
    TriaxialSpec spec;
    spec.deviator_stress = deviator_stress;
    spec.inertial_number = 1e-3;
    dem::StepCaches caches;
    PathState state = begin_path(world, spec, dem::mean_stress_tensor(world));
    while (!path_burst(world, caches, spec, {}, damping, dem::Mode::Reference, state)) {
    }
    return world;
}

TEST(StressProbe, ASampleAtIsotropicStressAnswersElastically) {
    StressProbeSpec spec;
    spec.directions = 8;
    const std::vector<StressProbe> probes = probe_all(settled_sample(), spec);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 there = probes[k].strain, back = probes[k + 4].strain;
        EXPECT_LE(norm(there + back), 0.02 * norm(there)) << probes[k].angle; // the same load taken off
        EXPECT_GT(probes[k].normalized, 0.95);
        EXPECT_GT(probes[k + 4].normalized, 0.95);
    }
}

// Where sheared samples lose stability first: lateral stress taken off, and axial with it [Hadda2013].
TEST(StressProbe, AShearedSampleIsLeastStableWhereItsConfinementIsTakenOff) {
    StressProbeSpec spec;
    spec.directions = 12;
    const std::vector<StressProbe> probes = probe_all(sheared_sample(8e4), spec);
    const auto least = std::min_element(probes.begin(), probes.end(), [](const StressProbe& a, const StressProbe& b) {
        return a.normalized < b.normalized;
    });
    EXPECT_LT(least->normalized, 0.95);
    EXPECT_GT(least->angle, 0.8 * pi);
    EXPECT_LT(least->angle, 1.3 * pi);
    const StressProbe &off = probes[6], &on = probes[0]; // 180 and 0 degrees: lateral stress alone
    EXPECT_GT(norm(off.strain), 1.05 * norm(on.strain)); // some contacts slip under the one, none under the other
}

TEST(StressProbe, ALoadBeyondTheStrengthFails) {
    StressProbeSpec spec;
    spec.directions = 4; // a quarter turn after the lateral one: axial
    spec.increment = 3;  // of the mean stress
    const ProbedState state = rest_for_probes(settled_sample(), spec, damping, {});
    const StressProbe axial = probe_direction(state, spec, 1, damping, {});
    EXPECT_EQ(axial.answer, Answer::Fails);
    EXPECT_TRUE(axial.is_unstable());
    EXPECT_GT(axial.strain[2], 0.5 * spec.max_strain);
}

TEST(StressProbe, TheStateItselfIsNotTouched) {
    const dem::World world = squeezed_lattice();
    StressProbeSpec spec;
    const ProbedState state = rest_for_probes(world, spec, damping, {});
    const StressProbe first = probe_direction(state, spec, 3, damping, {});
    probe_direction(state, spec, 7, damping, {});
    const StressProbe again = probe_direction(state, spec, 3, damping, {});
    EXPECT_EQ(first.second_order_work, again.second_order_work);
}

TEST(StressProbe, NeedsASampleThatCarriesAStress) {
    const dem::World world = test::two_grains(1e-4, 1e-4, -1e-6, {});
    EXPECT_THROW((void)rest_for_probes(world, {}, damping, {}), StateError);
}

} // namespace
} // namespace suffuse::triaxial
