// The quick protocols of preparation on 500 grains: what was specified is met, what was lent is given back, and neither
// threads nor a stop half-way change a bit.

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/target_density.hpp"
#include "suffuse/record/result_json.hpp"

#include <gtest/gtest.h>

#include "tests/support/clouds.hpp"
#include <string>

namespace suffuse::packing {
namespace {

constexpr double pressure = 1e5; // [Pa]

CompactSpec spec_of(Protocol protocol) {
    CompactSpec spec;
    spec.pressure = pressure;
    spec.protocol = protocol;
    return spec;
}

struct Prepared {
    dem::World world;
    CompactState state;
};

/// `stop_after` bursts the state goes through JSON and the caches are new, as after Ctrl-C and resume.
Prepared prepare(const CompactSpec& spec, int stop_after = -1, dem::Mode mode = dem::Mode::Reference) {
    Prepared result;
    result.world = test::sand_cloud(500);
    auto caches = std::make_unique<dem::StepCaches>();
    result.state = begin_compaction(result.world, spec, 0.2, mode);
    for (int bursts = 0; !compact_burst(result.world, *caches, spec, {}, result.state); ++bursts) {
        if (misses_void_ratio(result.world, spec, result.state)) {
            break;
        }
        if (bursts == stop_after) {
            result.state = nlohmann::json::parse(nlohmann::json(result.state).dump()).get<CompactState>();
            caches = std::make_unique<dem::StepCaches>();
        }
    }
    return result;
}

class Protocols : public testing::TestWithParam<std::tuple<Protocol, dem::Mode>> {
protected:
    static Prepared prepared(int stop_after = -1) { return prepare(spec(), stop_after, std::get<1>(GetParam())); }

    static CompactSpec spec() {
        const Protocol protocol = std::get<0>(GetParam());
        CompactSpec spec = spec_of(protocol);
        if (protocol == Protocol::Swift) {
            spec.start_porosity = 0.40;
        } else {
            spec.prepare.friction = radians(10);
        }
        return spec;
    }

    void TearDown() override { set_thread_count(1); }
};

TEST_P(Protocols, EndBalancedAtThePressureAndGiveBackWhatWasLent) {
    const dem::World start = test::sand_cloud(500);
    const Prepared sample = prepared();
    RecordProperty("steps", std::to_string(sample.state.steps));
    RecordProperty("void_ratio", std::to_string(dem::void_ratio(sample.world)));
    for (int a = 0; a < 3; ++a) {
        EXPECT_NEAR(sample.state.balance.stress(a, a), pressure, 5e-3 * pressure);
    }
    EXPECT_LE(sample.state.balance.equilibrium.unbalanced_force, 1e-3);
    EXPECT_EQ(sample.world.grains.mass, start.grains.mass);
    EXPECT_EQ(sample.world.grains.inertia, start.grains.inertia);
    EXPECT_EQ(sample.world.material.friction, start.material.friction);
    EXPECT_EQ(sample.state.lent, dem::Lent{});
}

TEST_P(Protocols, HaveTheSameBitsForAnyThreadsAndAfterAStopAnywhere) {
    const std::uint64_t hash = dem::state_hash(prepared().world);
    for (const int bursts : {0, 3, 7}) {
        set_thread_count(bursts + 2);
        EXPECT_EQ(dem::state_hash(prepared(bursts).world), hash) << bursts;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Preparation, Protocols,
    testing::Combine(
        testing::Values(Protocol::Swift, Protocol::Faithful), testing::Values(dem::Mode::Reference, dem::Mode::Fast)
    ),
    [](const auto& given) {
        return std::string(name_of(std::get<0>(given.param))) + "_" + dem::name_of(std::get<1>(given.param));
    }
);

TEST(Preparation, InFastModeTakeAnotherPathToTheSameState) {
    const CompactSpec spec = spec_of(Protocol::Faithful);
    const Prepared exact = prepare(spec), fast = prepare(spec, -1, dem::Mode::Fast);
    EXPECT_NE(dem::state_hash(fast.world), dem::state_hash(exact.world));
    EXPECT_NEAR(dem::void_ratio(fast.world), dem::void_ratio(exact.world), 0.01); // 500 grains scatter by that much
}

class SwiftAtAVoidRatio : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(SwiftAtAVoidRatio, MeetsItInAFewThousandStepsWhateverTheFrictionWhileItIsCompacted) {
    const auto [wanted, friction] = GetParam();
    CompactSpec spec = spec_of(Protocol::Swift);
    spec.void_ratio = wanted;
    spec.prepare.friction = radians(friction);
    std::int64_t steps = 0;
    Prepared sample;
    search_void_ratio(spec, {}, [&](const CompactSpec& trial) {
        sample = prepare(trial);
        steps += sample.state.steps;
        return dem::void_ratio(sample.world);
    });
    EXPECT_NEAR(dem::void_ratio(sample.world), wanted, spec.void_ratio_tolerance);
    EXPECT_EQ(sample.state.phase, CompactState::Phase::Done);
    EXPECT_EQ(sample.world.material.friction, sample.state.material.friction);
    EXPECT_LE(steps, 3000);
}

INSTANTIATE_TEST_SUITE_P(
    Preparation, SwiftAtAVoidRatio, testing::Combine(testing::Values(0.60, 0.68), testing::Values(0.0, 10.0, 37.0))
);

TEST(Swift, StepsNoLongerThanItsContactsAllow) {
    CompactSpec spec = spec_of(Protocol::Swift);
    spec.start_porosity = 0.405; // touching within a burst
    spec.prepare.friction = radians(10);
    dem::World world = test::sand_cloud(500);
    dem::StepCaches caches;
    CompactState state = begin_compaction(world, spec, 0.2);
    while (state.phase == CompactState::Phase::Compact) {
        const double stable = state.steps > 0 ? dem::stable_time_step(world) : 1;
        compact_burst(world, caches, spec, {}, state);
        EXPECT_LE(state.time_step, 1.2 * stable) << state.steps; // contacts come and go between two looks
    }
}

TEST(Swift, StartsAtTheSpecifiedPorosityFromALooserAndFromADenserCloud) {
    for (const double porosity : {0.45, 0.75}) {
        CompactSpec spec = spec_of(Protocol::Swift);
        spec.start_porosity = porosity;
        dem::World world = test::sand_cloud(500);
        const CompactState state = begin_compaction(world, spec, 0.2);
        EXPECT_NEAR(state.start_porosity, porosity, 1e-12); // rounding
        EXPECT_EQ(dem::porosity(world), state.start_porosity);
    }
}

TEST(Swift, DropsATrialThatIsTooDenseBeforeItHasSettled) {
    CompactSpec spec = spec_of(Protocol::Swift);
    const Prepared sample = prepare(spec);
    CompactState state;
    state.phase = CompactState::Phase::Settle;
    spec.void_ratio = dem::void_ratio(sample.world) + 2 * spec.void_ratio_tolerance;
    EXPECT_TRUE(misses_void_ratio(sample.world, spec, state));
    spec.void_ratio = dem::void_ratio(sample.world) - 2 * spec.void_ratio_tolerance; // it may still give way
    EXPECT_FALSE(misses_void_ratio(sample.world, spec, state));
}

TEST(Swift, SaysWhatItReachesWhenAVoidRatioIsOutOfReach) {
    const auto message_of = [](double wanted) -> std::string {
        CompactSpec spec = spec_of(Protocol::Swift);
        spec.void_ratio = wanted;
        try {
            search_void_ratio(spec, {}, [](const CompactSpec&) { return 0.55; }); // whatever the start
        } catch (const StateError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(message_of(0.45).find("0.5500"), std::string::npos) << message_of(0.45);
    EXPECT_NE(message_of(0.45).find("prepare.friction"), std::string::npos);
    EXPECT_NE(message_of(0.80).find("faithful"), std::string::npos);
    EXPECT_NE(message_of(2.00).find("starts at porosities"), std::string::npos);
}

} // namespace
} // namespace suffuse::packing
