// The tests of a laboratory on lattices, whose answers are closed forms, and on a packing, for what they hold.

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/triaxial/laboratory_numbers.hpp"
#include "suffuse/triaxial/path_loading.hpp"
#include "suffuse/triaxial/response.hpp"

#include <gtest/gtest.h>

#include "tests/support/lattices.hpp"
#include "tests/support/worlds.hpp"
#include <algorithm>
#include <cmath>
#include <string>

namespace suffuse::triaxial {
namespace {

constexpr double pressure = 1e5, damping = 0.2;
constexpr double still = 1e-7; // strain of a cell that had not quite come to rest when the test began

PathState run(dem::World& world, const TriaxialSpec& spec) {
    dem::StepCaches caches;
    PathState state = begin_path(world, spec, dem::mean_stress_tensor(world));
    while (!path_burst(world, caches, spec, {}, damping, dem::Mode::Reference, state)) {
        if (state.steps > 400'000) {
            ADD_FAILURE() << "no end";
            break;
        }
    }
    return state;
}

dem::World settled(dem::World world) {
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(dem::stable_time_step(world, {damping}), damping);
    plan.loading = dem::isotropic_stress(pressure);
    dem::settle(world, caches, plan, {}, 400'000);
    return world;
}

/// Face-centered spheres that neither slip nor come apart.
const dem::World& lattice() {
    static const dem::World world = [] {
        grains::Material bonded;
        bonded.adhesion_normal = bonded.adhesion_shear = 1e12;
        return settled(test::lattice_world(test::face_centered, 3, bonded));
    }();
    return world;
}

test::ElasticConstants constants() {
    return test::elastic_constants(test::face_centered, lattice().material);
}

/// 500 grains at 100 kPa.
const dem::World& packing() {
    static const dem::World world = settled(test::reference_packing("packing500"));
    return world;
}

double axial(const PathRow& row, int axis = 2) {
    return row.stress(axis, axis);
}

TEST(Oedometer, OfALatticeHasTheRatioOfItsElasticConstants) {
    dem::World world = lattice();
    OedometerSpec spec;
    spec.stresses = {2 * pressure, pressure};
    const std::vector<PathRow> rows = run(world, spec).rows;
    ASSERT_GT(rows.size(), 20U);
    const auto top = std::ranges::max_element(rows, {}, [](const PathRow& row) { return axial(row); });
    const double lateral = top->stress(0, 0) - rows.front().stress(0, 0), up = axial(*top) - axial(rows.front());
    // Spacings change by 1e-3, and with them the constants.
    EXPECT_NEAR(lateral / up / (constants().c12 / constants().c11), 1, 5e-3);
    EXPECT_NEAR(up / top->axial_strain / constants().c11, 1, 1e-2);
    EXPECT_NEAR(rows.back().axial_strain, 0, 1e-2 * top->axial_strain); // elastic: all comes back
    const CompressionNumbers numbers = compression_numbers(spec, rows);
    EXPECT_NEAR(*numbers.k0, lateral_mean(top->stress, 2) / axial(*top), 1e-12);
    EXPECT_NEAR(*numbers.swelling_index / *numbers.compression_index, 1, 0.15); // one curve, over two spans of it
}

TEST(Isotropic, OfALatticeHasItsBulkModulus) {
    dem::World world = lattice();
    IsotropicSpec spec;
    spec.stresses = {2 * pressure};
    const PathRow last = run(world, spec).rows.back();
    const double bulk = (constants().c11 + 2 * constants().c12) / 3;
    EXPECT_NEAR((last.mean_stress - pressure) / last.volumetric_strain / bulk, 1, 1e-2);
    EXPECT_NEAR(last.axial_strain, last.volumetric_strain / 3, 1e-3 * last.axial_strain);
}

TEST(Shear, OfALatticeHasItsShearModulusAlongEachPairOfAxes) {
    for (const ShearAxes axes : {ShearAxes{2, 0}, ShearAxes{0, 1}, ShearAxes{1, 2}}) {
        dem::World world = lattice();
        ShearSpec spec;
        spec.shear_axes = axes;
        spec.axis = axes.normal;
        spec.strain = 2e-3;
        const std::vector<PathRow> rows = run(world, spec).rows;
        const double stress = shear_stress(spec, rows.back().stress);
        EXPECT_NEAR(stress / rows.back().shear_strain / constants().c44, 1, 1e-2);
        EXPECT_NEAR(rows.back().shear_strain, spec.strain, 0.1 * spec.strain);
        EXPECT_NEAR(rows.back().void_ratio, rows.front().void_ratio, still);
    }
}

TEST(LaboratoryTests, HoldTheirStressesWithinTwoPercentInEveryRow) {
    for (const double friction : {0.0, 0.75}) {
        dem::World sample = packing();
        sample.material.friction = friction;
        sample = settled(sample);
        TriaxialSpec compression, extension, constant_mean, intermediate;
        extension.direction = Direction::Extension;
        constant_mean.path = Path::ConstantMean;
        intermediate.b = 0.5;
        PlaneStrainSpec plane;
        ShearSpec shear;
        shear.path = Path::ShearAtStress;
        IsotropicSpec isotropic;
        isotropic.stresses = {3e5, 1e5};
        for (TriaxialSpec spec :
             {compression, extension, constant_mean, intermediate, TriaxialSpec(plane), TriaxialSpec(shear),
              TriaxialSpec(isotropic)}) {
            for (const double number : {1e-3, 3e-3}) {
                spec.inertial_number = number;
                spec.strain = spec.stresses.empty() ? 0.02 : 0.2;
                dem::World world = sample;
                const PathState state = run(world, spec);
                EXPECT_LE(*find_hold_error(state.rows, spec.path), good_hold_error)
                    << static_cast<int>(spec.path) << " friction " << friction << " at " << number;
            }
        }
    }
}

TEST(LaboratoryTests, AccountForTheirWork) {
    ShearSpec shear, held;
    held.path = Path::ShearAtStress;
    OedometerSpec oedometer;
    oedometer.stresses = {4e5, 1e5};
    TriaxialSpec extension;
    extension.direction = Direction::Extension;
    for (TriaxialSpec spec : {TriaxialSpec(shear), TriaxialSpec(held), TriaxialSpec(oedometer), extension}) {
        spec.strain = spec.stresses.empty() ? 0.03 : 0.2;
        dem::World world = packing();
        const std::vector<PathRow> rows = run(world, spec).rows;
        const dem::EnergyParts energy = rows.back().energy;
        double most = 0; // an unloaded sample gives some of it back
        for (const PathRow& row : rows) {
            most = std::max(most, std::abs(row.energy.work));
        }
        EXPECT_NEAR(energy.unaccounted(), 0, 0.02 * most) << static_cast<int>(spec.path);
        EXPECT_LT(energy.damping, 0.1 * (energy.slip + energy.rolling + energy.damping));
    }
}

TEST(Extension, LowersTheAxialStressAtTheLateralOneOfTheStart) {
    dem::World world = packing();
    TriaxialSpec spec;
    spec.direction = Direction::Extension;
    spec.strain = 0.05;
    const std::vector<PathRow> rows = run(world, spec).rows;
    EXPECT_NEAR(rows.back().axial_strain, -0.05, 1e-3);
    const Response response = summarize(rows, spec);
    EXPECT_LT(response.peak_deviator, -2e4);
    EXPECT_LT(response.peak_strain, 0);
    EXPECT_GT(response.stiffness.value(), 0);
    EXPECT_FALSE(response.lost_at);
    const auto peak = std::ranges::min_element(rows, {}, &PathRow::deviator_stress);
    const double lateral = 0.5 * (peak->stress(0, 0) + peak->stress(1, 1)),
                 sine = (lateral - axial(*peak)) / (lateral + axial(*peak));
    EXPECT_NEAR(std::sin(response.friction_angle), sine, 0.02);
}

TEST(Extension, StopsAtAStressThatItComesToFromAbove) {
    dem::World world = packing();
    TriaxialSpec spec;
    spec.direction = Direction::Extension;
    spec.deviator_stress = 3e4;
    const PathState state = run(world, spec);
    EXPECT_NEAR(state.rows.back().deviator_stress, -3e4, 3e2);
    EXPECT_NEAR(state.balance.stress(2, 2), 7e4, 1e3); // at rest
}

TEST(TrueTriaxial, KeepsTheIntermediateStressAtItsShare) {
    for (const Direction direction : {Direction::Compression, Direction::Extension}) {
        for (const double b : {0.0, 0.3, 1.0}) {
            dem::World world = packing();
            TriaxialSpec spec;
            spec.direction = direction;
            spec.b = b;
            spec.strain = 0.02;
            for (const PathRow& row : run(world, spec).rows) {
                const auto [least, most] = std::minmax({axial(row), row.stress(1, 1)});
                EXPECT_NEAR(row.stress(0, 0), least + b * (most - least), 0.02 * most) << b;
                EXPECT_NEAR(row.stress(1, 1), pressure, 0.02 * most);
                EXPECT_GE(row.hold_error + 1e-5, std::abs(row.stress(1, 1) / pressure - 1)) << "over itself";
            }
        }
    }
}

TEST(PlaneStrain, StrainsInAPlane) {
    dem::World world = packing();
    const double width = world.cell.h(0, 0);
    PlaneStrainSpec spec;
    spec.strain = 0.02;
    const std::vector<PathRow> rows = run(world, spec).rows;
    EXPECT_NEAR(world.cell.h(0, 0), width, still * width);
    EXPECT_GT(rows.back().stress(0, 0), 1.2 * pressure); // which keeps the width
    EXPECT_NEAR(rows.back().stress(1, 1), pressure, 0.02 * pressure);
}

TEST(Cyclic, TurnsAtItsAmplitudeOfStressAndSaysHowMuchWaterCarries) {
    dem::World world = packing();
    CyclicSpec spec;
    spec.cycles->csr = 0.1;
    spec.cycles->number = 3;
    const PathState state = run(world, spec);
    const double amplitude = 2 * 0.1 * dem::mean_stress(state.start_stress);
    int turns = 0;
    for (std::size_t k = 1; k < state.rows.size(); ++k) {
        const PathRow &row = state.rows[k - 1], &next = state.rows[k];
        EXPECT_NEAR(
            row.excess_pore_pressure, lateral_mean(state.start_stress, 2) - lateral_mean(row.stress, 2), 1e-9 * pressure
        );
        EXPECT_NEAR(row.void_ratio, state.rows.front().void_ratio, still);
        if (next.leg != row.leg) {
            const double q = row.deviator_stress - state.rows.front().deviator_stress;
            EXPECT_NEAR(q * (row.leg % 2 == 0 ? 1 : -1), amplitude, 0.02 * amplitude) << row.leg;
            ++turns;
        }
    }
    EXPECT_EQ(turns, 5); // of six halves
    const CyclicNumbers numbers = cyclic_numbers(spec, state.rows);
    EXPECT_EQ(numbers.cycles, 3);
    EXPECT_FALSE(numbers.cycles_to_liquefaction);
    EXPECT_GT(numbers.pore_pressure_ratio, 0);
}

TEST(Cyclic, EndsWhereTheStrainFromTurnToTurnIsTooLarge) {
    dem::World world = packing();
    CyclicSpec spec;
    spec.cycles->strain = 5e-3;
    spec.cycles->double_amplitude = 8e-3; // in the second half, back from half a percent
    spec.strain = spec.cycles->double_amplitude;
    const PathState state = run(world, spec);
    EXPECT_EQ(cyclic_numbers(spec, state.rows).cycles_to_liquefaction, 1);
    EXPECT_NEAR(state.rows.back().axial_strain, 5e-3 - 8e-3, 1e-3);
}

TEST(Cyclic, AnAmplitudeAboveTheStrengthIsRefusedWhereNoWaterCarriesIt) {
    dem::World world = packing();
    CyclicSpec spec;
    spec.path = Path::Drained;
    spec.cycles->csr = 5;
    EXPECT_THROW(run(world, spec), StateError);
}

PathRow row_of(double stress, double void_ratio) {
    PathRow row;
    row.stress = diagonal({0.4 * stress, 0.4 * stress, stress});
    row.void_ratio = void_ratio;
    return row;
}

TEST(CompressionNumbers, AreTheSlopesOfFirstLoadingAndOfUnloading) {
    std::vector<PathRow> rows;
    const auto first = [](double stress) { return 0.9 - 0.2 * std::log10(stress / 1e5); };
    for (const double stress : {1e5, 1.4e5, 2e5, 3e5, 4e5}) {
        rows.push_back(row_of(stress, first(stress)));
    }
    for (const double stress : {2e5, 1e5, 2e5, 4e5}) { // down and up along one line, which is no first loading
        rows.push_back(row_of(stress, first(4e5) - 0.02 * std::log10(stress / 4e5)));
    }
    OedometerSpec spec;
    const CompressionNumbers numbers = compression_numbers(spec, rows);
    EXPECT_NEAR(*numbers.compression_index, 0.2, 1e-12);
    EXPECT_NEAR(*numbers.swelling_index, 0.02, 1e-12);
    EXPECT_NEAR(*numbers.k0, 0.4, 1e-12);
    for (const double stress : {8e5, 1.6e6}) { // on, and down again: a line of its own
        rows.push_back(row_of(stress, first(stress)));
    }
    for (const double stress : {8e5, 4e5}) {
        rows.push_back(row_of(stress, first(1.6e6) - 0.02 * std::log10(stress / 1.6e6)));
    }
    EXPECT_NEAR(*compression_numbers(spec, rows).swelling_index, 0.02, 1e-12);
    rows.resize(5);
    EXPECT_FALSE(compression_numbers(spec, rows).swelling_index);
    EXPECT_FALSE(compression_numbers(IsotropicSpec{}, rows).k0);
}

TEST(CompressionNumbers, OfATestThatOnlyUnloadsOrStaysWhereItIsAreNothing) {
    OedometerSpec spec;
    const CompressionNumbers unloaded =
        compression_numbers(spec, {row_of(1e5, 0.7), row_of(8e4, 0.702), row_of(5e4, 0.705)});
    EXPECT_TRUE(unloaded.swelling_index);
    EXPECT_FALSE(unloaded.compression_index || unloaded.k0);
    const std::vector<PathRow> stays{
        row_of(1e5, 0.7), row_of(1.001e5, 0.701), row_of(1.0005e5, 0.699), row_of(1.0003e5, 0.7)};
    const CompressionNumbers rested = compression_numbers(spec, stays);
    EXPECT_FALSE(rested.swelling_index || rested.compression_index || rested.k0);
}

TEST(ShearNumbers, RotateTheMajorStressByHalfTheAngleOfMohrsCircle) {
    PathRow start = row_of(1e5, 0.7), sheared = start;
    start.mean_stress = sheared.mean_stress = 6e4;
    sheared.shear_strain = 0.1;
    sheared.stress(0, 2) = sheared.stress(2, 0) = -3e4; // compression is positive
    const ShearNumbers numbers = shear_numbers(ShearSpec{}, {start, sheared});
    EXPECT_NEAR(numbers.peak_stress_ratio, 0.3, 1e-12);
    EXPECT_NEAR(numbers.peak_shear_strain, 0.1, 1e-12);
    EXPECT_NEAR(numbers.rotation, 0.5 * std::atan2(6e4, 6e4), 1e-12);
}

} // namespace
} // namespace suffuse::triaxial
