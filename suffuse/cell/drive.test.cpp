#include "suffuse/cell/drive.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::cell {
namespace {

TEST(Drive, AStrainRateIsTakenAsItIsCompressionPositive) {
    ServoState servo;
    Loading loading;
    loading.axis[1] = {Control::StrainRate, 3};
    const Mat3 gradient = drive({}, loading, {}, 1e-8, 0, servo);
    EXPECT_EQ(gradient, diagonal({0, -3, 0}));
}

TEST(Drive, AGivenVelocityGradientReplacesTheAxes) {
    ServoState servo;
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e5};
    loading.velocity_gradient = Mat3{{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}};
    EXPECT_EQ(drive({}, loading, {}, 1e-8, 0, servo), *loading.velocity_gradient);
}

/// Stress along x after `steps` steps of a linear elastic body of modulus 2e8 Pa under the servo, which believes in
/// `belief` times that, while something else changes the stress by `drift` [Pa/s].
double elastic_response(const ServoSpec& spec, int steps, double* most = nullptr, double drift = 0, double belief = 1) {
    constexpr double modulus = 2e8, dt = 1e-7, start = 1e3;
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e5};
    loading.servo = spec;
    Cell cell;
    ServoState servo;
    servo.modulus = belief * Vec3{modulus, modulus, modulus};
    double stress = start;
    for (int k = 0; k < steps; ++k) {
        cell.velocity_gradient = drive(cell, loading, {stress, 0, 0}, dt, 0, servo);
        stress += dt * (drift - modulus * cell.velocity_gradient(0, 0));
        if (most != nullptr) {
            *most = std::max(*most, stress);
        }
    }
    return stress;
}

ServoSpec secant() {
    ServoSpec servo;
    servo.max_rate = 1e9;
    return servo;
}

TEST(SecantServo, ApproachesTheTargetExponentiallyWithItsResponseTimeAndNeverOvershoots) {
    double most = 0;
    // Each step closes 1/100 of the gap.
    EXPECT_NEAR(elastic_response(secant(), 100, &most), 1e5 - 9.9e4 * std::pow(0.99, 100), 1e-5);
    EXPECT_NEAR(elastic_response(secant(), 3000, &most), 1e5, 1e-3);
    EXPECT_LE(most, 1e5 * (1 + 1e-12));
}

TEST(SecantServo, LeavesNoLagUnderAStressThatChangesByItself) {
    // As in a sample compressed along another axis: 2e9 Pa/s, a fifth of the target in each response time.
    EXPECT_NEAR(elastic_response(secant(), 3000, nullptr, 2e9), 1e5, 1e-2); // after 30 response times: rounding
    double most = 0;
    elastic_response(secant(), 3000, &most, 2e9);
    EXPECT_LE(most, 1e5 + 0.37 * 2e9 * 100 * 1e-7 * 1.1); // drift x response time / e, at the start
}

TEST(SecantServo, LeavesNoLagUnderAMeanStressWhileAnotherAxisIsCompressed) {
    constexpr double modulus = 2e8, dt = 1e-7, rate = 10, pressure = 1e5;
    Loading loading;
    loading.axis[0] = loading.axis[1] = {Control::MeanStress, pressure};
    loading.axis[2] = {Control::StrainRate, rate};
    loading.servo = secant();
    Cell cell;
    ServoState servo;
    servo.modulus = {modulus, modulus, modulus};
    Vec3 stress{pressure, pressure, pressure};
    double most = 0;
    for (int k = 0; k < 3000; ++k) {
        const double mean = (stress.x + stress.y + stress.z) / 3;
        most = std::max(most, mean);
        cell.velocity_gradient = drive(cell, loading, stress, dt, 0, servo);
        for (int a = 0; a < 3; ++a) {
            stress[a] -= dt * modulus * cell.velocity_gradient(a, a);
        }
    }
    EXPECT_NEAR((stress.x + stress.y + stress.z) / 3, pressure, 1e-2); // after 30 response times: rounding
    EXPECT_EQ(stress.x, stress.y);
    EXPECT_LE(
        most, pressure + modulus * rate * 100 * dt / 3
    ); // what the axis rises by in a response time, at the start
}

TEST(SecantServo, IsCalmWhenTheBodyIsTwiceAsStiffOrAsSoftAsItBelieves) {
    for (const double belief : {0.5, 2.0}) {
        double most = 0;
        EXPECT_NEAR(elastic_response(secant(), 3000, &most, 0, belief), 1e5, 1) << belief;
        EXPECT_LE(most, 1e5 + 0.08 * 9.9e4)
            << belief; // twice too stiff: damping ratio 1/sqrt(2), a fifteenth of the jump
    }
}

TEST(SecantServo, KeepsToItsLargestRateAndSqueezesASampleWithoutContacts) {
    ServoSpec servo;
    servo.max_rate = 7;
    Loading loading;
    loading.axis.fill({Control::Stress, 1e5});
    loading.servo = servo;
    ServoState state;
    EXPECT_EQ(drive({}, loading, {}, 1e-8, 0, state), diagonal({-7, -7, -7}));
    const Vec3 too_much{2e5, 2e5, 2e5};
    EXPECT_EQ(drive({}, loading, too_much, 1e-8, 0, state), diagonal({7, 7, 7}));
    EXPECT_EQ(drive({}, loading, {}, 1e-8, 0, state), diagonal({-7, -7, -7})); // whatever came before
}

TEST(LargestRate, GrowsAsTheRootOfTheStressToBearOrBorneOfLateUnlessItIsGiven) {
    Loading loading;
    loading.axis[0] = {Control::Stress, 4e4};
    ServoState state;
    EXPECT_DOUBLE_EQ(largest_rate(loading, state, 0.1), 20);
    state.mean_stress = {9e4, 25e4, 0}; // nobody holds the stress of the second axis
    EXPECT_DOUBLE_EQ(largest_rate(loading, state, 0.1), 30);
    loading.axis[0].value = 0; // to be unloaded
    EXPECT_DOUBLE_EQ(largest_rate(loading, state, 0.1), 30);
    EXPECT_EQ(largest_rate(loading, {}, 0.1), 0); // no stress, nothing to do
    loading.servo.max_rate = 7;
    EXPECT_EQ(largest_rate(loading, state, 0.1), 7);
}

TEST(LargestRate, LetsAnAxisFollowThoseThatAreStrained) {
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e4};
    loading.axis[2] = {Control::StrainRate, -80};
    EXPECT_EQ(largest_rate(loading, {}, 0.1), 160);
}

/// Stress of an elastic body, of shear modulus 1e8 Pa, that the servo lets go of its shear stresses under 100 kPa for
/// `steps` steps. @param known shear modulus that the servo believes in [Pa]
Mat3 released(int steps, double known, Cell& cell, double& most_against) {
    constexpr double dt = 1e-7, modulus = 2e8, shear_modulus = 1e8;
    Loading loading;
    loading.axis.fill({Control::Stress, 1e5});
    loading.servo = secant();
    loading.shear_released = true;
    ServoState servo;
    servo.modulus = {modulus, modulus, modulus};
    servo.shear_modulus = {known, known, known};
    Mat3 stress = diagonal({1e5, 1e5, 1e5});
    stress(0, 1) = stress(1, 0) = 2e4;
    stress(1, 2) = stress(2, 1) = -3e4;
    for (int k = 0; k < steps; ++k) {
        servo.shear_stress = shear_stresses(stress);
        cell.velocity_gradient = drive(cell, loading, {stress(0, 0), stress(1, 1), stress(2, 2)}, dt, 0, servo);
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                const double rate = cell.velocity_gradient(a, b) + cell.velocity_gradient(b, a);
                stress(a, b) -= dt * (a == b ? modulus / 2 : shear_modulus) * rate;
            }
        }
        most_against = std::max({most_against, -stress(0, 1), stress(1, 2)});
    }
    return stress;
}

TEST(ReleasedShear, DecaysInTheResponseTimeWithoutRingingAndLeavesAxesAsTheyAre) {
    Cell cell;
    double most_against = -1;
    const Mat3 stress = released(100, 1e8, cell, most_against);
    EXPECT_NEAR(stress(0, 1), 2e4 * std::pow(0.99, 100), 1e-6);
    EXPECT_NEAR(stress(1, 2), -3e4 * std::pow(0.99, 100), 1e-6);
    EXPECT_EQ(stress(0, 2), 0);
    EXPECT_EQ(cell.velocity_gradient, transpose(cell.velocity_gradient)); // the cell does not turn
    EXPECT_EQ(shear_stresses(cell.velocity_gradient).y, 0);
    EXPECT_EQ(stress(0, 0), 1e5);
    EXPECT_LE(most_against, 0);
}

TEST(ReleasedShear, DoesNotRingInABodyFarSofterThanTheAffineModulus) {
    Cell cell;
    double most_against = -1;
    const Mat3 stress = released(20'000, 2e9, cell, most_against); // of twenty times its own: ten response times
    EXPECT_NEAR(stress(0, 1), 0, 2e4 * 5e-5);
    EXPECT_LE(most_against, 0);
}

TEST(ReleasedShear, ShearsACloudByNoMoreThanTheShareOfItsNoiseInThePressure) {
    Loading loading;
    loading.axis.fill({Control::Stress, 1e5});
    loading.servo = secant();
    loading.servo.max_rate = 250;
    loading.shear_released = true;
    ServoState servo; // no contacts, no stiffness
    const double dt = 1e-7;
    Mat3 gradient = drive({}, loading, {}, dt, 0, servo);
    EXPECT_EQ(gradient, diagonal({-250, -250, -250}));
    servo.shear_stress = {0, 0, 1e-3}; // a hundred-millionth of the pressure
    gradient = drive({}, loading, {}, dt, 0, servo);
    EXPECT_NEAR(gradient(0, 1), 0.5 * 1e-8 / (100 * dt), 1e-12);
    servo.shear_stress = {0, -1e5, 0};
    gradient = drive({}, loading, {}, dt, 0, servo);
    EXPECT_EQ(gradient(2, 0), -125); // the largest rate counts the whole shear strain
    EXPECT_EQ(gradient(0, 2), -125);
}

TEST(ReleasedShear, IsForTheSecantServoTogetherWithAStressThatIsHeld) {
    Loading loading;
    loading.shear_released = true;
    EXPECT_FALSE(releases_shear(loading));
    loading.axis[1] = {Control::Stress, 1e5};
    EXPECT_TRUE(releases_shear(loading));
    loading.servo.kind = ServoKind::Inertial;
    EXPECT_FALSE(releases_shear(loading));
    loading.servo.kind = ServoKind::Secant;
    loading.velocity_gradient = Mat3{};
    EXPECT_FALSE(releases_shear(loading));
}

TEST(InertialServo, OscillatesAboutTheTargetAndItsGrowthDampingCalmsIt) {
    ServoSpec servo;
    servo.kind = ServoKind::Inertial;
    servo.mass = 2e-2;
    servo.damping = 0.25;
    servo.max_rate = 1e9;
    double most = 0;
    elastic_response(servo, 2000, &most);
    EXPECT_GT(most, 1.1e5); // a mass on a spring
    EXPECT_NEAR(elastic_response(servo, 40000), 1e5, 1e2);
}

TEST(Drive, ControlsEachAxisOnItsOwn) {
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e5};
    loading.axis[2] = {Control::StrainRate, -2};
    ServoState state;
    state.modulus = {1e8, 1e8, 1e8};
    const double dt = 1e-8;
    const Mat3 gradient = drive({}, loading, {0.9999e5, 5e5, 7e5}, dt, 0, state);
    EXPECT_NEAR(gradient(0, 0), -10 / (1e8 * 100 * dt), 1e-10);
    EXPECT_EQ(gradient(1, 1), 0);
    EXPECT_EQ(gradient(2, 2), 2);
}

TEST(Drive, AShareIsTakenOfWhatTheOtherAxisBearsAndShearIsAddedToTheAxes) {
    Loading loading;
    loading.axis[1] = {Control::Share, 1e4, 0.3, 2};
    const Vec3 stress{9e4, 6e4, 2e5};
    EXPECT_DOUBLE_EQ(wanted_stress(loading, 1, stress), 1e4 + 0.3 * 2e5);
    loading.axis[2] = {Control::StrainRate, 5};
    loading.simple_shear(0, 2) = 7;
    ServoState servo;
    servo.modulus = {1e8, 1e8, 1e8};
    Cell cell;
    const Mat3 gradient = drive(cell, loading, stress, 1e-7, 1, servo);
    EXPECT_EQ(gradient(0, 2), 7);
    EXPECT_EQ(gradient(2, 0), 0);
    EXPECT_EQ(gradient(2, 2), -5);
    EXPECT_LT(gradient(1, 1), 0); // 10 kPa are missing
}

} // namespace
} // namespace suffuse::cell
