// What is read off a stress-strain curve, on curves whose answers are known.

#include "suffuse/triaxial/response.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace suffuse::triaxial {
namespace {

constexpr double lateral = 1e5; // [Pa]

/// A drained curve from q(strain) and the volumetric strain.
std::vector<PathRow> curve(
    const std::function<double(double)>& deviator, const std::function<double(double)>& volumetric, double last = 0.2,
    int rows = 400
) {
    std::vector<PathRow> result;
    for (int k = 0; k <= rows; ++k) {
        PathRow row;
        row.axial_strain = last * k / rows;
        row.deviator_stress = deviator(row.axial_strain);
        row.mean_stress = lateral + row.deviator_stress / 3;
        row.volumetric_strain = volumetric(row.axial_strain);
        result.push_back(row);
    }
    return result;
}

double zero(double /*strain*/) {
    return 0;
}

/// Straight up to 300 kPa at 2 %, down to 200 kPa at 10 %, flat from there.
double peaked(double e) {
    return e < 0.02 ? 1.5e7 * e : e < 0.1 ? 3e5 - 1.25e6 * (e - 0.02) : 2e5;
}

TEST(Summarize, FindsPeakStrengthAndItsAngle) {
    const Response response = summarize(curve(peaked, zero));
    EXPECT_NEAR(response.peak_deviator, 3e5, 1);
    EXPECT_NEAR(response.peak_strain, 0.02, 1e-12);
    EXPECT_NEAR(response.peak_ratio, 3e5 / 2e5, 1e-9);
    EXPECT_NEAR(response.friction_angle, std::asin(3.0 / 5), 1e-9); // (400 - 100)/(400 + 100)
    EXPECT_NEAR(response.final_deviator, 2e5, 1e-6);
}

TEST(Summarize, OfATestThatStaysOnTheOtherSideOfZeroHasItsHighestDeviator) {
    const auto unloads = [](double e) { return -5e4 + std::min(2e6 * e, 4e4); };
    for (const Direction direction : {Direction::Compression, Direction::Extension}) {
        TriaxialSpec spec;
        spec.direction = direction;
        const double sign = direction == Direction::Compression ? 1 : -1;
        std::vector<PathRow> rows = curve(unloads, zero);
        for (PathRow& row : rows) {
            row.axial_strain *= sign, row.deviator_stress *= sign;
        }
        const Response response = summarize(rows, spec);
        EXPECT_NEAR(response.peak_deviator, sign * -1e4, 1e-6);
        EXPECT_NEAR(response.peak_strain, sign * 0.02, 1e-9);
        EXPECT_NEAR(response.stiffness.value(), 2e6, 1) << "to half of the 40 kPa";
    }
}

TEST(Summarize, StiffnessIsTheSecantToHalfThePeak) {
    EXPECT_NEAR(*summarize(curve(peaked, zero)).stiffness, 1.5e7, 1);
    // A curve that softens on the way: q = 3e5 sqrt(e/0.02) reaches half at a quarter of the strain.
    const auto root = [](double e) { return e < 0.02 ? 3e5 * std::sqrt(e / 0.02) : 3e5 - 1e5 * (e - 0.02); };
    EXPECT_NEAR(*summarize(curve(root, zero)).stiffness / (1.5e5 / 0.005), 1, 1e-3); // straight between rows
}

TEST(Summarize, FromAnAnisotropicStartTheStiffnessIsThatOfTheIncrement) {
    const auto lifted = [](double e) { return 1e5 + (e < 0.02 ? 1e7 * e : 2e5); };
    EXPECT_NEAR(*summarize(curve(lifted, zero)).stiffness, 1e7, 1);
}

TEST(Summarize, DilatancyDoesNotDependOnHowFarApartRowsAre) {
    const std::vector<PathRow> all = curve(peaked, [](double e) { return -0.3 * e; });
    for (const std::size_t every : {1U, 3U, 7U, 15U}) {
        std::vector<PathRow> rows;
        for (std::size_t k = 0; k < all.size(); k += every) {
            rows.push_back(all[k]);
        }
        EXPECT_NEAR(*summarize(rows).dilatancy, 0.3, 1e-9) << every;
    }
}

TEST(HoldError, IsThatOfTheWorstRowOfAPathThatHoldsAStress) {
    std::vector<PathRow> rows = curve(peaked, zero);
    rows[3].hold_error = 0.03;
    rows[9].hold_error = 0.11;
    for (const Path path : {Path::Drained, Path::ConstantMean}) {
        EXPECT_EQ(find_hold_error(rows, path), 0.11);
    }
    for (const Path path : {Path::Undrained, Path::Proportional, Path::ConstantDeviator}) {
        EXPECT_FALSE(find_hold_error(rows, path));
    }
}

TEST(Summarize, DilatancyAndContractionAreSlopesAndExtremesOfTheVolume) {
    // Contracts by 0.4 % until 1 %, then dilates at 0.3, then at 0.6 between 5 and 9 %, then stays.
    const auto volume = [](double e) {
        return e < 0.01 ? 0.4 * e : e < 0.05 ? 0.004 - 0.3 * (e - 0.01) : e < 0.09 ? -0.008 - 0.6 * (e - 0.05) : -0.032;
    };
    const Response response = summarize(curve(peaked, volume));
    EXPECT_NEAR(*response.dilatancy, 0.6, 1e-6);
    EXPECT_NEAR(response.largest_contraction, 0.004, 1e-12);
    EXPECT_NEAR(response.final_volumetric_strain, -0.032, 1e-12);
}

TEST(Summarize, DilatancyIsThatOverOnePercentOfStrain) {
    const auto dilates_over = [](double span) { // at 0.6, from 5 % on
        return *summarize(curve(peaked, [=](double e) { return -0.6 * std::clamp(e - 0.05, 0.0, span); })).dilatancy;
    };
    EXPECT_NEAR(dilates_over(0.01), 0.6, 1e-9);
    EXPECT_NEAR(dilates_over(0.005), 0.3, 1e-9);
}

TEST(Summarize, NoiseOfSingleRowsIsNoDilatancy) {
    int k = 0;
    const auto noisy = [&](double /*strain*/) { return ++k % 2 == 0 ? 1e-5 : -1e-5; }; // slopes of 0.04 row to row
    EXPECT_LT(*summarize(curve(peaked, noisy)).dilatancy, 3e-3);
}

TEST(Summarize, OfAContractiveCurveDilatancyIsZeroAndThePeakIsTheEnd) {
    const Response response =
        summarize(curve([](double e) { return 2e5 * e / (0.01 + e); }, [](double e) { return 0.1 * e; }));
    EXPECT_EQ(response.dilatancy, 0);
    EXPECT_NEAR(response.peak_strain, 0.2, 1e-12);
    EXPECT_EQ(response.peak_deviator, response.final_deviator);
}

TEST(SecondOrderWork, OfAnElasticPathIsThatOfItsModuli) {
    constexpr double bulk = 5e7, shear = 3e7;
    PathRow before, after;
    before.mean_stress = 1e5;
    after.axial_strain = 1e-3;
    after.volumetric_strain = 4e-4;
    const double distortion = 1e-3 - 4e-4 / 3;
    after.mean_stress = 1e5 + bulk * 4e-4;
    after.deviator_stress = 3 * shear * distortion;
    const double expected = bulk * 4e-4 * 4e-4 + 3 * shear * distortion * distortion;
    EXPECT_NEAR(second_order_work(before, after) / expected, 1, 1e-9); // rounding of 1e5 + 2e4
}

/// Undrained: q = 60 kPa (2 s - s^2) with s = strain/0.01, the lateral stress falling from 100 kPa with `loss`.
std::vector<PathRow> undrained(const std::function<double(double)>& loss) {
    std::vector<PathRow> rows = curve([](double e) { return 6e4 * (2 * e / 0.01 - e * e / 1e-4); }, zero, 0.019);
    for (PathRow& row : rows) {
        row.excess_pore_pressure = loss(row.axial_strain);
        row.mean_stress -= row.excess_pore_pressure;
    }
    return rows;
}

TEST(Summarize, InstabilityOfAnUndrainedTestIsThePeakOfItsDeviator) {
    const auto rows = undrained([](double e) { return 4e6 * e; });
    const Response response = summarize(rows, Path::Undrained);
    ASSERT_TRUE(response.instability);
    // Rows lie 4.75e-5 apart and 22 of them are averaged on either side: found within a row after the peak, and the
    // mean of a parabola over a half-width of s = 0.1 is a third of 0.01 lower.
    EXPECT_NEAR(response.instability->axial_strain, 0.01, 5e-5);
    EXPECT_NEAR(response.instability->deviator_stress, 6e4 * (1 - 0.0036), 60);
    EXPECT_NEAR(response.instability->mean_stress, 1e5 + 2e4 - 4e4, 300);
    EXPECT_NEAR(*response.excess_pore_pressure, 4e6 * 0.019, 1e-6);
}

TEST(Summarize, InstabilityOfADrainedTestIsItsPeakAndNoneWhereItHardens) {
    const auto dilates = [](double e) { return -0.5 * e; }; // at a held lateral stress the volume has no part in it
    const Response response = summarize(curve(peaked, dilates));
    ASSERT_TRUE(response.instability);
    EXPECT_NEAR(response.instability->axial_strain, 0.02, 2.5e-3); // rises faster than it falls: later by some rows
    EXPECT_GE(response.instability->axial_strain, 0.02);
    EXPECT_FALSE(summarize(curve([](double e) { return 2e5 * e / (0.01 + e); }, dilates)).instability);
}

TEST(Summarize, NoiseOfSingleRowsIsNoInstability) {
    int k = 0;
    const auto noisy = [&](double e) { return 1e6 * e + (++k % 2 == 0 ? 1e3 : -1e3); }; // 500 Pa a row, +- 1 kPa
    EXPECT_FALSE(summarize(curve(noisy, zero)).instability);
}

TEST(Summarize, ATestLiquefiesWhereLessThanATwentiethOfTheMeanStressIsLeft) {
    const auto flows = [](double left) {
        std::vector<PathRow> rows = curve(zero, zero);
        rows[200].mean_stress = left * lateral;
        return rows;
    };
    EXPECT_TRUE(summarize(flows(0.049), Path::Undrained).liquefied.value());
    EXPECT_FALSE(summarize(flows(0.051), Path::Undrained).liquefied.value());
    EXPECT_FALSE(summarize(flows(0.049), Path::Drained).liquefied);
    EXPECT_FALSE(summarize(flows(0.049), Path::ConstantMean).excess_pore_pressure);
}

TEST(Summarize, AtConstantDeviatorASampleFailsAtTheHighestPorePressure) {
    // q = 60 kPa held; the pore pressure rises to 50 kPa, where the sample begins to contract, and falls again.
    std::vector<PathRow> rows = curve([](double) { return 6e4; }, [](double e) { return 0.1 * (e - 0.02); }, 0.04);
    for (PathRow& row : rows) {
        row.excess_pore_pressure = 5e4 * (1 - std::pow(row.axial_strain / 0.02 - 1, 2));
        row.mean_stress = 1.2e5 - row.excess_pore_pressure;
    }
    const Response response = summarize(rows, Path::ConstantDeviator);
    EXPECT_NEAR(*response.excess_pore_pressure, 5e4, 1e-6);
    EXPECT_NEAR(response.peak_ratio, 6.0 / 7, 1e-9);
    EXPECT_NEAR(response.peak_strain, 0.02, 1e-12);
    EXPECT_NEAR(response.friction_angle, std::asin(6.0 / (6 + 10)), 1e-9); // of 110 and 50 kPa
    EXPECT_FALSE(response.stiffness) << "q is held";
    ASSERT_TRUE(response.instability); // it contracts from the start while the mean stress falls
    EXPECT_NEAR(response.instability->axial_strain, 0, 1.1e-3);
    EXPECT_EQ(response.liquefied, false);
    // Where q is lost at 1 % strain, the sample fails there, whatever it bears afterwards.
    for (std::size_t k = 100; k < 120; ++k) {
        rows[k].deviator_stress = 0.94 * 6e4;
    }
    const double before = rows[99].excess_pore_pressure;
    rows[110].mean_stress = 1e3;
    EXPECT_EQ(summarize(rows, Path::ConstantDeviator).excess_pore_pressure, before);
    EXPECT_EQ(summarize(rows, Path::ConstantDeviator).liquefied, true);
}

TEST(Summarize, AHeldStressThatIsLostIsReportedWithTheStrainAtWhichItWas) {
    std::vector<PathRow> rows = curve(peaked, zero);
    EXPECT_FALSE(summarize(rows).lost_at);
    rows[50].mean_stress -= 0.19 * lateral;
    EXPECT_FALSE(summarize(rows).lost_at);
    rows[60].mean_stress -= 0.21 * lateral;
    EXPECT_EQ(summarize(rows).lost_at, rows[60].axial_strain);
    EXPECT_FALSE(summarize(rows, Path::Undrained).lost_at); // holds no stress
}

TEST(Summarize, OfNothingIsNothing) {
    EXPECT_EQ(summarize({}).peak_deviator, 0);
    EXPECT_FALSE(summarize(std::vector<PathRow>(1)).stiffness);
}

TEST(Summarize, WhatATestCannotShowIsNothing) {
    EXPECT_FALSE(summarize(curve(peaked, zero, 0.009)).dilatancy) << "less than one percent of strain";
    EXPECT_EQ(summarize(curve(peaked, zero, 0.011)).dilatancy, 0);
    EXPECT_FALSE(summarize(curve([](double e) { return 1e5 - 1e6 * e; }, zero)).stiffness) << "q falls from the start";
}

TEST(BeginPath, SetsTheStrainRateFromTheInertialNumber) {
    dem::World world = test::reference_packing("packing500");
    dem::StepCaches caches;
    dem::step(world, caches, test::plan_of(1e-9));
    TriaxialSpec spec;
    spec.inertial_number = 1e-3;
    const PathState state = begin_path(world, spec, diagonal({1e5, 1e5, 1e5}));
    // I = rate d sqrt(rho/p): back to what was specified with the mean diameter by mass, between the smallest and the
    // largest.
    const double inertial = state.strain_rate * state.median_diameter * std::sqrt(2600 / 1e5);
    EXPECT_NEAR(inertial, 1e-3 / dem::slower_turning, 1e-15); // grains are lent inertia, and turn so much more slowly
    const auto [least, most] = std::minmax_element(world.grains.radius.begin(), world.grains.radius.end());
    EXPECT_GT(state.median_diameter, 2 * *least);
    EXPECT_LT(state.median_diameter, 2 * *most);
    ASSERT_EQ(state.rows.size(), 1U);
    EXPECT_EQ(state.rows[0].axial_strain, 0);
}

TEST(BeginPath, LendsInertiaThatTheEndOfTheShearGivesBackToTheBit) {
    for (const GrainInertia inertia : {GrainInertia::Lent, GrainInertia::Own}) {
        dem::World world = test::reference_packing("packing500");
        dem::StepCaches caches;
        dem::advance(world, caches, test::plan_of(1e-9), 1);
        const dem::World before = world;
        TriaxialSpec spec;
        spec.inertia = inertia;
        spec.strain = 2e-4;
        PathState state = begin_path(world, spec, dem::mean_stress_tensor(world));
        EXPECT_EQ(world.grains.mass != before.grains.mass, inertia == GrainInertia::Lent);
        while (!path_burst(world, caches, spec, {}, 0.2, dem::Mode::Reference, state)) {
        }
        EXPECT_EQ(world.grains.mass, before.grains.mass);
        EXPECT_EQ(world.grains.inertia, before.grains.inertia);
    }
}

TEST(BeginPath, LendsNothingWithAGivenTimeStepNorAtAConstantDeviatorNorRotationWithoutFriction) {
    TriaxialSpec spec;
    const grains::Material sand;
    EXPECT_EQ(lent_during(spec, sand), (dem::Lent{true, true}));
    spec.time_step = 1e-8;
    EXPECT_EQ(lent_during(spec, sand), dem::Lent{});
    spec.time_step = 0;
    spec.path = Path::ConstantDeviator;
    EXPECT_EQ(lent_during(spec, sand), dem::Lent{});
    spec.path = Path::Undrained;
    grains::Material smooth = sand;
    smooth.friction = 0;
    EXPECT_EQ(lent_during(spec, smooth), (dem::Lent{true, false}));
    EXPECT_EQ(strain_rate_of(spec, smooth, 1e-3, 1e5), 2 * strain_rate_of(spec, sand, 1e-3, 1e5));
}

TEST(BeginPath, RefusesASampleWithoutStress) {
    dem::World world = test::reference_packing("packing500");
    for (const double pressure : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(begin_path(world, {}, diagonal({pressure, pressure, pressure})), StateError) << pressure;
    }
}

TEST(BeginPath, AConstantDeviatorNeedsATwentiethOfTheMeanStress) {
    const auto begin = [](double ratio) {
        dem::World world = test::reference_packing("packing500");
        const double p = 1e5, q = ratio * p;
        begin_path(world, {.path = Path::ConstantDeviator}, diagonal({p - q / 3, p - q / 3, p + 2 * q / 3}));
    };
    EXPECT_THROW(begin(0.0499), StateError);
    EXPECT_NO_THROW(begin(0.0501));
}

TEST(BeginPath, RefusesAPaceAStrainOrRowsThatAreNotAboveZero) {
    dem::World world = test::reference_packing("packing500");
    const auto begin = [&](double inertial_number, double strain, int rows) {
        TriaxialSpec spec;
        spec.inertial_number = inertial_number;
        spec.strain = strain;
        spec.rows = rows;
        begin_path(world, spec, diagonal({1e5, 1e5, 1e5}));
    };
    EXPECT_THROW(begin(0, 0.2, 400), CaseError);
    EXPECT_THROW(begin(1e-3, 0, 400), CaseError);
    EXPECT_THROW(begin(1e-3, std::numeric_limits<double>::quiet_NaN(), 400), CaseError);
    EXPECT_THROW(begin(1e-3, 0.2, 0), CaseError);
    EXPECT_NO_THROW(begin(1e-3, 0.2, 400));
}

} // namespace
} // namespace suffuse::triaxial
