// The computed time step against the stiffest mode of the contact network, step by step while samples are compacted:
// how much of the stability limit it is, damping included, where contacts form by the hundreds within a burst and
// later.

#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/spring_network.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/pace.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "tests/support/clouds.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <ostream>

namespace suffuse::packing {
namespace {

/// Highest of all 6N frequencies of the touching contacts, all of them sticking [rad/s]: of M^-1/2 K M^-1/2.
double exact_frequency(const dem::World& world) {
    const grains::Grains& grains = world.grains;
    const dem::SpringNetwork network(world, world.material.shear_ratio);
    const auto count = static_cast<Eigen::Index>(6 * grains.size());
    const auto weight = [&](Eigen::Index k) {
        const auto g = static_cast<std::size_t>(k / 6);
        return 1 / std::sqrt(k % 6 < 3 ? grains.mass[g] : grains.inertia[g]);
    };
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index k = 0; k < count; ++k) {
        dem::Motions in{std::vector<Vec3>(grains.size()), std::vector<Vec3>(grains.size())};
        dem::Motions out{std::vector<Vec3>(network.rows()), std::vector<Vec3>(network.rows())};
        const auto g = static_cast<std::size_t>(k / 6);
        const Vec3 unit{k % 3 == 0 ? 1.0 : 0, k % 3 == 1 ? 1.0 : 0, k % 3 == 2 ? 1.0 : 0};
        (k % 6 < 3 ? in.shift[g] : in.turn[g]) = unit;
        network.apply(in, out);
        for (Eigen::Index l = 0; l < count; ++l) {
            const auto h = static_cast<std::size_t>(l / 6);
            const Vec3& of_grain = l % 6 < 3 ? out.shift[h] : out.turn[h];
            matrix(l, k) = weight(k) * weight(l) * of_grain[static_cast<int>(l % 3)];
        }
    }
    return std::sqrt(
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[count - 1]
    );
}

TEST(TimeStep, RestsOnAFrequencyNearTheHighestOfAllSixNOfThePacking) {
    dem::World world = test::sand_cloud(120);
    CompactSpec spec{.pressure = 1e5, .protocol = Protocol::Swift};
    CompactState state = begin_compaction(world, spec, 0.2);
    dem::StepCaches caches;
    while (!compact_burst(world, caches, spec, {}, state)) {
    }
    const double exact = exact_frequency(world);
    EXPECT_NEAR(dem::highest_frequency(world, 4000) / exact, 1, 1e-4);
    EXPECT_LE(dem::highest_frequency(world) / exact, 1 + 1e-9);
    EXPECT_GE(dem::highest_frequency(world) / exact, 0.95);
}

struct Way {
    const char* name;
    Protocol protocol = Protocol::Faithful;
    double damping = 0.2;
    double rolling_stiffness = 7.5, twisting_stiffness = 0;
    grains::ContactLaw law = grains::ContactLaw::LinearRolling;
    double size_ratio = 2; ///< of the largest grain over the smallest
    double friction = 37;  ///< while it is compacted [degrees]
    double adhesion = 0;   ///< likewise [Pa]
};

std::ostream& operator<<(std::ostream& out, const Way& way) {
    return out << way.name;
}

class TimeStepOf : public testing::TestWithParam<Way> {
protected:
    static dem::World cloud() {
        const Way& way = GetParam();
        dem::World world = test::cloud_of_ratio(way.size_ratio, 200);
        grains::Material& material = world.material;
        material.law = way.law;
        material.modulus = way.law == grains::ContactLaw::HertzMindlin ? 70e9 : material.modulus;
        material.rolling_stiffness = way.rolling_stiffness;
        material.twisting_stiffness = way.twisting_stiffness;
        material.rolling_friction = material.twisting_friction = -1; // without a limit nothing hides a mode that grows
        return world;
    }

    static CompactSpec spec() {
        const Way& way = GetParam();
        CompactSpec spec{.pressure = 1e5, .protocol = way.protocol};
        spec.prepare.friction = radians(way.friction);
        if (way.protocol == Protocol::Slow) {
            spec.start_porosity = 0.48; // its gas takes ten thousands of steps
        }
        if (way.adhesion > 0) {
            spec.prepare.adhesion_normal = spec.prepare.adhesion_shear = way.adhesion;
        }
        return spec;
    }

    /// Of the stability limit of the network now that `time_step` is.
    static double share_of_limit(const dem::World& world, double time_step) {
        const double limit = 2 / dem::highest_frequency(world, 300);
        return time_step / (dem::share_when_damped(GetParam().damping, world.material.viscous_damping) * limit);
    }
};

TEST_P(TimeStepOf, IsAtMostNineTenthsOfTheLimitAtEachLook) {
    dem::World world = cloud();
    const CompactSpec specified = spec();
    CompactState state = begin_compaction(world, specified, GetParam().damping);
    dem::StepCaches caches;
    double most = 0;
    // The first burst, in pieces.
    state.lent = choose_lent(world, specified, state);
    dem::lend_inertia(world, state.median_diameter, {}, state.lent);
    state.time_step = choose_time_step(world, specified, state.damping);
    const dem::StepPlan plan = choose_pace(world, specified, {}, state).plan;
    for (int piece = 0; piece < 10; ++piece) {
        dem::advance(world, caches, plan, 5);
        most = std::max(most, share_of_limit(world, plan.dt));
    }
    RecordProperty("first_burst", std::to_string(most));
    EXPECT_LE(most, 0.9) << "in the first 50 steps";
    for (bool over = false; !over && state.steps < 4000;) {
        const double before = state.time_step;
        over = compact_burst(world, caches, specified, {}, state);
        most = std::max(most, share_of_limit(world, std::min(before, state.time_step)));
    }
    RecordProperty("share_of_limit", std::to_string(most));
    EXPECT_LE(most, 0.9);
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        EXPECT_LE(world.grains.radius[g] * norm(world.grains.spin[g]), 10) << "[m/s]: some 6 is the root of p/rho";
    }
    EXPECT_LE(dem::mean_stress(state.balance.stress), 2e5);
}

INSTANTIATE_TEST_SUITE_P(
    Compaction, TimeStepOf,
    testing::Values(
        Way{.name = "faithful"}, Way{.name = "faithful_10", .friction = 10},
        Way{.name = "faithful_adhesive", .adhesion = 1e6}, Way{.name = "faithful_equal", .size_ratio = 1},
        Way{.name = "faithful_wide", .size_ratio = 5},
        Way{.name = "faithful_hertz", .law = grains::ContactLaw::HertzMindlin},
        Way{.name = "faithful_twisting", .twisting_stiffness = 7.5},
        Way{.name = "faithful_stiff", .rolling_stiffness = 30}, Way{.name = "faithful_soft", .rolling_stiffness = 0.1},
        Way{.name = "faithful_damped", .damping = 0.9}, Way{.name = "faithful_undamped", .damping = 0},
        Way{.name = "swift", .protocol = Protocol::Swift},
        Way{.name = "swift_wide", .protocol = Protocol::Swift, .size_ratio = 5},
        Way{.name = "swift_hertz", .protocol = Protocol::Swift, .law = grains::ContactLaw::HertzMindlin},
        Way{.name = "swift_twisting", .protocol = Protocol::Swift, .twisting_stiffness = 7.5},
        Way{.name = "swift_damped", .protocol = Protocol::Swift, .damping = 0.9},
        Way{.name = "wide", .protocol = Protocol::Wide, .size_ratio = 5},
        Way{.name = "wide_10", .protocol = Protocol::Wide, .size_ratio = 5, .friction = 10},
        Way{.name = "slow", .protocol = Protocol::Slow},
        Way{.name = "slow_stiff", .protocol = Protocol::Slow, .rolling_stiffness = 30},
        Way{.name = "slow_wide", .protocol = Protocol::Slow, .size_ratio = 8}
    ),
    [](const auto& given) { return given.param.name; }
);

} // namespace
} // namespace suffuse::packing
