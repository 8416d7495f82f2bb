// The gate of `wide`: samples of a size ratio of 6.5 and 10 against those of `slow`, or of grains with their own
// inertia throughout [docs/theory/preparation.md]. With 40 coarse grains the void ratio scatters by 0.05 between seeds,
// so that samples of one seed are compared. The numbers that take long are in wide_seeds.csv (the last three to four
// digits), written by
//   suffuse_validation --gtest_also_run_disabled_tests --gtest_filter='*WriteTheTableForWide'

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/stats/coordination.hpp"
#include "suffuse/stats/fines.hpp"
#include "suffuse/stats/stress_by_fraction.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "validation/seeds.hpp"
#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace suffuse::packing {
namespace {

using namespace validation;

const std::string table = test::in_checkout("validation/wide_seeds.csv");
constexpr std::array<const char*, 7> names{
    "steps", "void_ratio", "mechanical_coordination", "active_fines", "large_large", "fines_stress", "overlap"};
constexpr std::size_t void_ratio = 1, coordination = 2, overlap = 6;

struct WideSample {
    const char* name;
    double size_ratio;
    int grains;   ///< 40 coarse ones and 20 % of fines by mass
    bool adheres; ///< 1 MPa while it is compacted; against `slow`, else against grains with their own inertia
};

constexpr std::uint64_t seeds = 16;
// Fifteen means of sixteen differences all lie within so many standard errors in 19 of 20 tables of samples that do not
// differ (Student's distribution).
constexpr double most_errors = 3.5;
// Two quantities do differ: samples of lent mass are looser (ratio 6.5, plain: void ratio +0.029 +- 0.009), and have
// fewer contacts (ratio 10: -0.14 +- 0.04). Their bounds cover what was measured, and docs/theory/preparation.md says
// so.
constexpr double most_looser = 0.04, most_contacts = 0.2;
constexpr double most_steps = 0.2; // of the reference's

constexpr std::array<WideSample, 3> samples{
    {{"loose 6.5", 6.5, 2786, true}, {"plain 6.5", 6.5, 2786, false}, {"plain 10", 10, 10'040, false}}};

dem::World wide_cloud(const WideSample& sample, std::uint64_t seed) {
    grains::Soil soil;
    soil.coarse = grains::Grading{{0.28e-3, 0.35e-3, 0.42e-3}, {0, 0.5, 1}, ""};
    soil.fines = soil.coarse;
    for (double& d : soil.fines->diameter) {
        d /= sample.size_ratio;
    }
    soil.fines_content = 0.20;
    soil.grading_tolerance = 0.05; // a coarse grain of 40 is 2.5 % of them
    const Cloud made = make_cloud(grains::sample_soil(soil, sample.grains), PackSpec{}, 2600, seed);
    dem::World world;
    world.cell = made.cell;
    world.reference_h = made.cell.h;
    world.grains = made.grains;
    dem::sort_along_curve(world);
    return world;
}

/// Grains with their own inertia throughout: a time step is given, one that networks allow.
double own_time_step(const dem::World& cloud, double pressure) {
    constexpr double of_pairs = 0.5; // grains with several neighbors are quicker than pairs
    return of_pairs * dem::stable_time_step(cloud, {.pressure = pressure}, 1);
}

Row measure_wide(const WideSample& sample, std::uint64_t seed, Protocol protocol) {
    dem::World world = wide_cloud(sample, seed);
    CompactSpec spec;
    spec.pressure = 1e5;
    spec.protocol = protocol;
    if (sample.adheres) {
        spec.prepare.adhesion_normal = spec.prepare.adhesion_shear = 1e6;
    }
    if (protocol == Protocol::Faithful) {
        spec.time_step = own_time_step(world, spec.pressure);
    }
    const std::int64_t steps = prepare(world, spec);
    const stats::FinesState fines = stats::measure_fines(world);
    return {
        static_cast<double>(steps),
        fines.void_ratio,
        stats::measure_coordination(world).mechanical,
        fines.active_fraction,
        fines.contact_share.large_large,
        stats::measure_stress_by_fraction(world).fines_share,
        dem::measure_equilibrium(world).max_overlap_ratio};
}

std::vector<Row> measure_wide_seeds(const WideSample& sample, Protocol protocol) {
    std::vector<Row> rows;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        rows.push_back(measure_wide(sample, seed, protocol));
    }
    return rows;
}

/// Mean of the differences of samples of one seed, and its standard error.
struct Difference {
    double mean = 0, error = 0;
};

Difference paired(const std::vector<Row>& a, const std::vector<Row>& b, std::size_t k) {
    std::vector<Row> differences;
    for (std::size_t s = 0; s < a.size(); ++s) {
        differences.push_back({a[s][k] - b[s][k]});
    }
    return {mean(differences, 0), deviation(differences, 0) / std::sqrt(static_cast<double>(a.size()))};
}

TEST(WideGate, DISABLED_WriteTheTableForWide) {
    std::ofstream file(table);
    file << fmt::format("sample,{}\n", fmt::join(names, ","));
    for (const WideSample& sample : samples) {
        for (const Row& row : measure_wide_seeds(sample, sample.adheres ? Protocol::Slow : Protocol::Faithful)) {
            file << fmt::format("{},{}\n", sample.name, fmt::join(row, ",")) << std::flush;
        }
    }
    EXPECT_TRUE(file.good());
}

TEST(WideGate, WideMeetsTheMeansOfTheSlowWayInAFifthOfItsSteps) {
    for (const WideSample& sample : samples) {
        const std::vector<Row> reference = read_table(table, sample.name);
        ASSERT_EQ(reference.size(), seeds);
        const std::vector<Row> wide = measure_wide_seeds(sample, Protocol::Wide);
        for (std::size_t k = 1; k < names.size(); ++k) {
            const auto [difference, error] = paired(wide, reference, k);
            fmt::print(
                "{:10} {:24} {:.4f}, wide {:.4f}: {:+.4f} +- {:.4f}\n", sample.name, names[k], mean(reference, k),
                mean(wide, k), difference, error
            );
            if (k == void_ratio) {
                EXPECT_LE(std::abs(difference), most_looser) << sample.name;
            } else if (k == coordination) {
                EXPECT_LE(std::abs(difference), most_contacts) << sample.name;
            } else if (k != overlap) { // the largest of each sample: a matter of stiffness
                EXPECT_LE(std::abs(difference), most_errors * error) << sample.name << ", " << names[k];
            }
        }
        fmt::print("{:10} steps {:.0f}, wide {:.0f}\n", sample.name, mean(reference, 0), mean(wide, 0));
        EXPECT_LE(mean(wide, 0), most_steps * mean(reference, 0)) << sample.name;
    }
}

} // namespace
} // namespace suffuse::packing
