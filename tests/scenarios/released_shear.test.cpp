// Samples whose cell shears while they are compacted, so that no shear stress between the axes is left.

#include "suffuse/base/parallel.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/packing/compact.hpp"

#include <gtest/gtest.h>

#include "tests/support/clouds.hpp"
#include "tests/support/run_text.hpp"
#include <atomic>
#include <string>

namespace suffuse::test {
namespace {

constexpr double pressure = 1e5; // [Pa]

dem::World loose_sample(bool shear_released, packing::Protocol protocol) {
    packing::CompactSpec spec;
    spec.pressure = pressure;
    spec.protocol = protocol;
    spec.shear_released = shear_released;
    spec.prepare.adhesion_normal = spec.prepare.adhesion_shear = 1e6;
    dem::World world = sand_cloud(300);
    dem::StepCaches caches;
    packing::CompactState state = begin_compaction(world, spec, 0.2);
    while (!compact_burst(world, caches, spec, {}, state)) {
    }
    return world;
}

double deviator_to_pressure(const dem::World& world) {
    return dem::deviator_stress(dem::mean_stress_tensor(world)) / pressure;
}

class ReleasedShear : public testing::TestWithParam<packing::Protocol> {};

TEST_P(ReleasedShear, LeavesNoDeviatorStressWhereAKeptOneIsSeveralPercent) {
    const dem::World kept = loose_sample(false, GetParam()), released = loose_sample(true, GetParam());
    RecordProperty("kept", std::to_string(deviator_to_pressure(kept)));
    RecordProperty("released", std::to_string(deviator_to_pressure(released)));
    RecordProperty("shear_strain", std::to_string(released.cell.h(0, 1) / released.cell.h(1, 1)));
    EXPECT_GT(deviator_to_pressure(kept), 0.03);
    EXPECT_LT(deviator_to_pressure(released), 0.01); // by the balance: 0.5 % of shear stress, and of each axis
    EXPECT_EQ(kept.servo.shear_modulus, Vec3{});
    EXPECT_EQ(kept.servo.shear_stress, Vec3{});
    const Mat3& h = released.cell.h;
    EXPECT_NE(h(0, 1), 0); // the cell has sheared, a little, and barely turned
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
        EXPECT_LT(std::abs(h(a, b)), 0.1 * h(b, b));
        EXPECT_NEAR(h(a, b), h(b, a), 1e-2 * h(b, b));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Protocols, ReleasedShear, testing::Values(packing::Protocol::Faithful, packing::Protocol::Swift),
    [](const auto& test) { return std::string(name_of(test.param)); }
);

TEST(ReleasedShearSample, HasTheSameBitsForAnyNumberOfThreads) {
    std::vector<std::uint64_t> hashes;
    for (const int threads : {1, 2}) {
        set_thread_count(threads);
        hashes.push_back(dem::state_hash(loose_sample(true, packing::Protocol::Swift)));
    }
    set_thread_count(1);
    EXPECT_EQ(hashes[0], hashes[1]);
}

/// Everything that may follow starts from the sheared cell.
const std::string stages = R"(
shear_stresses = "released"
[[study.s.stage]]
name           = "harder"
do             = "settle"
pressure       = "150 kPa"
shear_stresses = "released"
[[study.s.stage]]
name   = "sheared"
do     = "triaxial"
strain = "1 %"
[[study.s.stage]]
name     = "erosion"
from     = "initial"
do       = "erode"
passes   = 1
gradient = 0.05
)";

TEST(ReleasedShearSample, GoesThroughTestsAndErosionAndIsTheSameAfterAStop) {
    const std::string text = reference_constants + reference_soil() + "[study.s]\nsoil = \"sand\"\nparticles = 500\n" +
                             cloud_and_initial + stages;
    const TempFolder straight, broken;
    const job::RunReport report = run_text(text, straight.path());
    ASSERT_TRUE(report.failures.empty()) << report.failures.front().message;
    for (const std::string stage : {"initial", "harder"}) { // the case specifies a stress error of 0.1 %
        const nlohmann::json numbers = stage_of(straight.path(), stage);
        EXPECT_LT(numbers.at("deviator_stress"), 2e-3 * numbers.at("mean_stress").get<double>()) << stage;
    }
    const nlohmann::json strength = stage_of(straight.path(), "sheared").at("response");
    EXPECT_GT(strength.at("peak_deviator"), 1e5);
    const nlohmann::json pass = stage_of(straight.path(), "erosion").at("passes").at(0);
    EXPECT_LT(std::abs(pass.at("volumetric_strain").get<double>()), 0.1);
    EXPECT_GT(pass.at("permeability_before"), 0);

    int stops = 0;
    for (int pulses = 10;; pulses *= 2) {
        std::atomic<bool> stop{false};
        run::RunOptions options;
        options.stop = &stop;
        options.progress_interval = 0;
        int left = pulses;
        options.on_progress = [&](const run::Progress&) { stop = --left <= 0; };
        if (run_text(text, broken.path(), options).outcome != record::Outcome::Stopped) {
            break;
        }
        ++stops;
    }
    EXPECT_GE(stops, 3);
    for (const std::string stage : {"initial", "harder", "sheared", "erosion"}) {
        EXPECT_EQ(stage_of(broken.path(), stage).at("state_hash"), stage_of(straight.path(), stage).at("state_hash"))
            << stage;
    }
}

} // namespace
} // namespace suffuse::test
