// The gate of triaxial tests with lent inertia: strength, volume and contacts lie within two standard deviations of
// those of tests whose grains have their own, seed by seed from the same samples
// [docs/theory/periodic-cell-and-servo.md]. The numbers of the latter are in own_inertia_seeds.csv, written by
//   suffuse_validation --gtest_also_run_disabled_tests --gtest_filter='*WriteTheTableOfOwnInertia'

#include "suffuse/dem/inspect.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/run_path.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "validation/seeds.hpp"
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace suffuse::triaxial {
namespace {

using namespace validation;

constexpr std::uint64_t seeds = 8;
const std::string table = test::in_checkout("validation/own_inertia_seeds.csv");
constexpr std::array<const char*, 7> names{"steps",          "q_at_2_percent",    "peak_q",      "final_q",
                                           "friction_angle", "volumetric_strain", "coordination"};
constexpr std::size_t volumetric = 5;

struct Sample {
    Preparation preparation;
    Path path;

    [[nodiscard]] std::string name() const {
        return fmt::format("{} {}", preparation.name, path == Path::Drained ? "drained" : "undrained");
    }
};

std::vector<Sample> samples() {
    const packing::Prepare dense{radians(10), {}, {}}, loose{{}, 1e6, 1e6};
    std::vector<Sample> all;
    for (const Preparation& way :
         {Preparation{"dense", dense}, {"loose", loose}, {"dense silty", dense, true}, {"loose silty", loose, true}}) {
        for (const Path path : {Path::Drained, Path::Undrained}) {
            all.push_back({way, path});
        }
    }
    return all;
}

double deviator_at(const std::vector<PathRow>& rows, double strain) {
    for (const PathRow& row : rows) {
        if (row.axial_strain >= strain) {
            return row.deviator_stress;
        }
    }
    return 0;
}

Row shear(dem::World world, Path path, GrainInertia inertia) {
    TriaxialSpec spec;
    spec.path = path;
    spec.inertia = inertia;
    spec.strain = path == Path::Drained ? 0.2 : 0.05;
    dem::StepCaches caches;
    PathState state = begin_path(world, spec, dem::mean_stress_tensor(world));
    while (!path_burst(world, caches, spec, {}, 0.2, dem::Mode::Reference, state)) {
    }
    const Response response = summarize(state.rows, path);
    return {
        static_cast<double>(state.steps),
        deviator_at(state.rows, 0.02),
        response.peak_deviator,
        response.final_deviator,
        degrees(response.friction_angle),
        response.final_volumetric_strain,
        state.rows.back().mechanical_coordination};
}

std::vector<Row> measure_seeds(const Sample& sample, GrainInertia inertia) {
    packing::CompactSpec spec;
    spec.pressure = 1e5;
    spec.prepare = sample.preparation.prepare;
    std::vector<Row> rows;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        dem::World world = cloud(sample.preparation, seed);
        prepare(world, spec);
        rows.push_back(shear(world, sample.path, inertia));
    }
    return rows;
}

TEST(TriaxialGate, DISABLED_WriteTheTableOfOwnInertia) {
    std::ofstream file(table);
    file << fmt::format("test,{}\n", fmt::join(names, ","));
    for (const Sample& sample : samples()) {
        for (const Row& row : measure_seeds(sample, GrainInertia::Own)) {
            file << fmt::format("{},{}\n", sample.name(), fmt::join(row, ","));
        }
    }
    EXPECT_TRUE(file.good());
}

TEST(TriaxialGate, LentInertiaLiesWithinTwoDeviationsOfOwn) {
    for (const Sample& sample : samples()) {
        const std::vector<Row> own = read_table(table, sample.name()), lent = measure_seeds(sample, GrainInertia::Lent);
        ASSERT_EQ(own.size(), seeds) << sample.name();
        for (std::size_t k = 0; k < names.size(); ++k) {
            const double off = (mean(lent, k) - mean(own, k)) / deviation(own, k);
            fmt::print(
                "{:22} {:18} own {:.5g} +- {:.2g}, lent {:.5g} +- {:.2g}: {:+.1f}\n", sample.name(), names[k],
                mean(own, k), deviation(own, k), mean(lent, k), deviation(lent, k), off
            );
            const bool is_held = sample.path == Path::Undrained && k == volumetric;
            if (k > 0 && !is_held) {
                EXPECT_LE(std::abs(off), 2) << sample.name() << ", " << names[k];
            }
        }
        EXPECT_LE(mean(lent, 0), 0.5 * mean(own, 0)) << sample.name();
    }
}

} // namespace
} // namespace suffuse::triaxial
