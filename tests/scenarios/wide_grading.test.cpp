// A small sample of size ratio 10 by the protocol `wide`: what was specified is met in far fewer steps than `faithful`
// takes, what was lent is given back, and neither threads nor a stop half-way change a bit.

#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/seed.hpp"
#include "suffuse/record/result_json.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace suffuse::packing {
namespace {

constexpr double pressure = 1e5; // [Pa]

/// Thirty coarse grains and 5 % of fines, ten times smaller.
dem::World wide_cloud() {
    grains::Soil soil;
    soil.coarse = grains::Grading{{0.28e-3, 0.35e-3, 0.42e-3}, {0, 0.5, 1}, ""};
    soil.fines = grains::Grading{{0.028e-3, 0.035e-3, 0.042e-3}, {0, 0.5, 1}, ""};
    soil.fines_content = 0.05;
    soil.grading_tolerance = 0.1;
    const Cloud made = make_cloud(grains::sample_soil(soil, 1610), PackSpec{}, 2600, 3);
    dem::World world;
    world.cell = made.cell;
    world.reference_h = made.cell.h;
    world.grains = made.grains;
    dem::sort_along_curve(world);
    return world;
}

struct Prepared {
    dem::World world;
    CompactState state;
};

/// `stop_after` bursts the state goes through JSON and the caches are new, as after Ctrl-C and resume.
Prepared prepare(Protocol protocol, const Prepare& how, int stop_after = -1) {
    CompactSpec spec;
    spec.pressure = pressure;
    spec.protocol = protocol;
    spec.prepare = how;
    Prepared result;
    result.world = wide_cloud();
    auto caches = std::make_unique<dem::StepCaches>();
    result.state = begin_compaction(result.world, spec, 0.2);
    for (int bursts = 0; !compact_burst(result.world, *caches, spec, {}, result.state); ++bursts) {
        if (bursts == stop_after) {
            result.state = nlohmann::json::parse(nlohmann::json(result.state).dump()).get<CompactState>();
            caches = std::make_unique<dem::StepCaches>();
        }
    }
    return result;
}

const Prepare plain{}, loose{.adhesion_normal = 1e6, .adhesion_shear = 1e6}, dense{.friction = 0};

TEST(WideGrading, SettlesAtThePressureAndGivesBackWhatWasLent) {
    const dem::World start = wide_cloud();
    for (const Prepare& how : {plain, loose, dense}) {
        const Prepared sample = prepare(Protocol::Wide, how);
        for (int a = 0; a < 3; ++a) {
            EXPECT_NEAR(sample.state.balance.stress(a, a), pressure, 5e-3 * pressure);
        }
        EXPECT_LE(sample.state.balance.equilibrium.unbalanced_force, 1e-3);
        EXPECT_EQ(sample.world.grains.mass, start.grains.mass);
        EXPECT_EQ(sample.world.grains.inertia, start.grains.inertia);
        EXPECT_EQ(sample.world.material.friction, start.material.friction);
        EXPECT_EQ(sample.state.lent, dem::Lent{});
    }
}

TEST(WideGrading, TakesAThirdOfTheStepsOfFaithfulWhereASkeletonCollapses) {
    const std::int64_t wide = prepare(Protocol::Wide, loose).state.steps;
    EXPECT_LT(3 * wide, prepare(Protocol::Faithful, loose).state.steps);
}

TEST(WideGrading, HasTheSameBitsForAnyThreadsAndAfterAStopAnywhere) {
    const std::uint64_t hash = dem::state_hash(prepare(Protocol::Wide, plain).world);
    for (const int bursts : {3, 70}) {
        set_thread_count(bursts == 3 ? 2 : 3);
        EXPECT_EQ(dem::state_hash(prepare(Protocol::Wide, plain, bursts).world), hash) << bursts;
    }
    set_thread_count(1);
}

} // namespace
} // namespace suffuse::packing
