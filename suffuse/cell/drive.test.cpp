#include "suffuse/cell/drive.hpp"

#include <gtest/gtest.h>

namespace suffuse::cell {
namespace {

TEST(Drive, AStrainRateIsTakenAsItIsCompressionPositive) {
    Loading loading;
    loading.axis[1] = {Control::StrainRate, 3};
    const Mat3 gradient = drive({}, loading, {}, {}, 1e-8);
    EXPECT_EQ(gradient, diagonal({0, -3, 0}));
}

TEST(Drive, AGivenVelocityGradientReplacesTheAxes) {
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e5};
    loading.velocity_gradient = Mat3{{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}};
    EXPECT_EQ(drive({}, loading, {}, {}, 1e-8), *loading.velocity_gradient);
}

/// Stress along x after `steps` steps of a linear elastic body of modulus 2e8 Pa under the servo.
double elastic_response(const ServoSpec& servo, int steps, double* most = nullptr) {
    constexpr double modulus = 2e8, dt = 1e-7;
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e5};
    loading.servo = servo;
    Cell cell;
    ServoState state;
    state.modulus = {modulus, modulus, modulus};
    double stress = 0;
    for (int k = 0; k < steps; ++k) {
        cell.velocity_gradient = drive(cell, loading, state, diagonal({stress, 0, 0}), dt);
        stress -= modulus * dt * cell.velocity_gradient(0, 0);
        if (most != nullptr) {
            *most = std::max(*most, stress);
        }
    }
    return stress;
}

TEST(SecantServo, ApproachesTheTargetExponentiallyWithItsResponseTimeAndNeverOvershoots) {
    ServoSpec servo; // secant
    servo.response = 400;
    servo.max_rate = 1e9;
    double most = 0;
    // Each step closes 1/400 of the gap.
    EXPECT_NEAR(elastic_response(servo, 400, &most), 1e5 * (1 - std::pow(1 - 1.0 / 400, 400)), 1e-6);
    EXPECT_NEAR(elastic_response(servo, 8000, &most), 1e5, 1e-3);
    EXPECT_LE(most, 1e5);
}

TEST(SecantServo, KeepsToItsLargestRateAndSqueezesASampleWithoutContacts) {
    ServoSpec servo;
    servo.max_rate = 7;
    Loading loading;
    loading.axis.fill({Control::Stress, 1e5});
    loading.servo = servo;
    EXPECT_EQ(drive({}, loading, {}, {}, 1e-8), diagonal({-7, -7, -7}));
    const Mat3 too_much = diagonal({2e5, 2e5, 2e5});
    EXPECT_EQ(drive({}, loading, {}, too_much, 1e-8), diagonal({7, 7, 7}));
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
    const Mat3 gradient = drive({}, loading, state, diagonal({0.9999e5, 5e5, 7e5}), dt);
    EXPECT_NEAR(gradient(0, 0), -10 / (1e8 * 400 * dt), 1e-10);
    EXPECT_EQ(gradient(1, 1), 0);
    EXPECT_EQ(gradient(2, 2), 2);
}

} // namespace
} // namespace suffuse::cell
