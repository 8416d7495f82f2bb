#include "suffuse/motion/integrator.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <utility>

namespace suffuse::motion {
namespace {

struct Grain {
    Vec3 position, velocity, spin;
};

constexpr double mass = 2, inertia = 0.5;

Grain moved(const StepMotion& step, Grain grain, const Vec3& force, const Vec3& torque, double free = 1) {
    shift(step, (free / mass) * force, free, grain.position, grain.velocity);
    spin_on(step, (free / inertia) * torque, free, grain.spin);
    return grain;
}

TEST(Integrator, FollowsTheSumOfTheSchemeUnderAConstantForce) {
    // Kick, then drift: x_n = x_0 + n v_0 dt + a dt2 n (n + 1)/2.
    const StepMotion step = plan_motion(0.01, 0, 0, {}, {});
    Grain grain{{1, 2, 3}, {0.5, 0, 0}, {0, 0, 4}};
    const int n = 1000;
    for (int k = 0; k < n; ++k) {
        grain = moved(step, grain, {4, 0, -6}, {0, 1, 0});
    }
    EXPECT_NEAR(grain.position.x, 1 + n * 0.005 + 2e-4 * n * (n + 1) / 2, 1e-9); // rounding of 1000 additions
    EXPECT_NEAR(grain.position.z, 3 - 3e-4 * n * (n + 1) / 2, 1e-9);
    EXPECT_NEAR(grain.velocity.z, -3 * 0.01 * n, 1e-10);
    EXPECT_NEAR(grain.spin.y, 2 * 0.01 * n, 1e-10);
    EXPECT_EQ(grain.spin.z, 4);
}

TEST(Integrator, LocalDampingTakesAShareOfAForceThatDrivesAndAddsItToOneThatBrakes) {
    const StepMotion step = plan_motion(0.01, 0.3, 0, {}, {});
    const Grain grain{{}, {1, -1, 0}, {0, 0, 1}};
    const Grain next = moved(step, grain, {2, 2, 2}, {0, 0, -0.5});
    EXPECT_NEAR(next.velocity.x - 1, 0.01 * 0.7, 1e-15); // drives
    EXPECT_NEAR(next.velocity.y + 1, 0.01 * 1.3, 1e-15); // brakes
    EXPECT_DOUBLE_EQ(next.velocity.z, 0.01 * 0.7);       // at rest: the half step ahead decides
    EXPECT_NEAR(next.spin.z, 1 - 0.01 * 1.3, 1e-15);
}

TEST(Integrator, LocalDampingSeesTheMotionAgainstTheCellNotThatOfTheCell) {
    Mat3 gradient = diagonal({-1, 0, 0});
    const StepMotion step = plan_motion(0.001, 0.5, 0, gradient, gradient);
    const Grain grain{{2, 0, 0}, {-2 + 0.1, 0, 0}, {}}; // moves back, but forward against the cell
    const Grain next = moved(step, grain, {2, 0, 0}, {});
    const double convection = -1 * grain.velocity.x;
    EXPECT_NEAR((next.velocity.x - grain.velocity.x) / 0.001, 0.5 + convection, 1e-12);
}

TEST(Integrator, DragBringsTheMotionAgainstTheCellToRest) {
    const StepMotion step = plan_motion(0.01, 0, 10, {}, {});
    Grain grain{{}, {1, 0, 0}, {0, 2, 0}};
    for (int k = 0; k < 50; ++k) {
        grain = moved(step, grain, {}, {});
    }
    EXPECT_NEAR(grain.velocity.x, std::pow(0.9, 50), 1e-14);
    EXPECT_NEAR(grain.spin.y, 2 * std::pow(0.9, 50), 1e-14);
}

TEST(Integrator, AHeldGrainKeepsItsMotionWhateverTheForces) {
    const StepMotion step = plan_motion(0.01, 0.2, 5, {}, {});
    const Grain next = moved(step, {{}, {1, 2, 3}, {4, 5, 6}}, {100, 100, 100}, {1, 1, 1}, 0);
    EXPECT_EQ(next.velocity, (Vec3{1, 2, 3}));
    EXPECT_EQ(next.spin, (Vec3{4, 5, 6}));
    EXPECT_EQ(next.position, (Vec3{0.01, 0.02, 0.03}));
}

TEST(Integrator, ANewMeanMotionIsGivenToTheGrainsWithItsSpin) {
    const Mat3 gradient{{{{0, -2, 0}, {2, 0, 0}, {0, 0, 0}}}}; // rotation about z at 2 rad/s
    const StepMotion step = plan_motion(1e-6, 0, 0, {}, gradient);
    const Grain next = moved(step, {{1, 0, 0}, {}, {}}, {}, {});
    EXPECT_EQ(next.velocity, (Vec3{0, 2, 0}));
    EXPECT_EQ(next.spin, (Vec3{0, 0, 2}));
}

TEST(Integrator, TheSpinOfTheMeanMotionIsThatOfARotationAboutAnyAxis) {
    const Vec3 rate{3, 5, 7}; // v = rate x position, and a stretch that does not turn
    const Mat3 gradient{{{{1, -7 + 2, 5}, {7 + 2, -1, -3}, {-5, 3, 0}}}};
    EXPECT_EQ(plan_motion(1e-6, 0, 0, {}, gradient).spin_change, rate);
    EXPECT_EQ(plan_motion(1e-6, 0, 0, gradient, {}).spin_change, -rate);
}

TEST(Integrator, WhetherAForceDrivesOrBrakesIsDecidedInTheMiddleOfTheStep) {
    constexpr double dt = 0.01, damping = 0.2;
    for (const auto& [velocity, left] : {std::pair{-0.0049, 1 - damping}, std::pair{-0.0051, 1 + damping}}) {
        EXPECT_DOUBLE_EQ(damped(1.0, velocity, dt, damping), left);
        EXPECT_DOUBLE_EQ(damped(Double4{1, 0, 0, 0}, Double4{velocity, 0, 0, 0}, dt, damping)[0], left);
    }
}

template <class Vec, class Matrix>
void expect_coasting_as_moving(const MotionOf<Vec, Matrix>& step, double is_free = 1) {
    const Double4 free = Double4{} + is_free, nothing{};
    Double4 position{0.3, -0.7, 0.0, 5}, velocity{-0.2, -0.0, 0.9, 7}, spin{-0.0, 4, -1, 9};
    Double4 other_position = position, other_velocity = velocity, other_spin = spin;
    for (int k = 0; k < 50; ++k) {
        shift(step, nothing, free, position, velocity);
        spin_on(step, nothing, free, spin);
        coast(step, free, other_position, other_velocity, other_spin);
    }
    for (int a = 0; a < 3; ++a) { // the bits, also of the sign of a zero
        EXPECT_EQ(std::bit_cast<std::uint64_t>(position[a]), std::bit_cast<std::uint64_t>(other_position[a]));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(velocity[a]), std::bit_cast<std::uint64_t>(other_velocity[a]));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(spin[a]), std::bit_cast<std::uint64_t>(other_spin[a]));
    }
}

TEST(Integrator, AGrainThatNothingPushesCoastsToTheSameBits) {
    const Mat3 sheared{{{{-1, 0.3, 0}, {0.3, 0.5, 0}, {0, 0, 0.2}}}}, upright{{{{-1, 0, 0}, {0, 0.5, 0}, {0, 0, 0}}}};
    expect_coasting_as_moving(in_lanes(plan_motion(1e-3, 0.2, 0, sheared, 1.1 * sheared)));
    expect_coasting_as_moving(in_diagonals(plan_motion(1e-3, 0.2, 0, upright, 1.1 * upright)));
    expect_coasting_as_moving(in_diagonals(plan_motion(1e-3, 0, 0, {}, {})));
}

TEST(Integrator, AGrainThatOnlyDragSlowsCoastsToTheSameBitsHeldOrFree) {
    const Mat3 sheared{{{{-1, 0.3, 0}, {0.3, 0.5, 0}, {0, 0, 0.2}}}}, upright{{{{-1, 0, 0}, {0, 0.5, 0}, {0, 0, 0}}}};
    for (const double free : {1.0, 0.0}) {
        expect_coasting_as_moving(in_lanes(plan_motion(1e-3, 0.2, 40, sheared, 1.1 * sheared)), free);
        expect_coasting_as_moving(in_diagonals(plan_motion(1e-3, 0.2, 40, upright, 1.1 * upright)), free);
        expect_coasting_as_moving(in_diagonals(plan_motion(1e-3, 0, 40, {}, {})), free);
    }
}

/// Drift of a grain's place in the cell after a strain of 0.5, in `steps` steps.
double drift(int steps) {
    const Mat3 gradient{{{{-1, 0.3, 0}, {0.3, 0.5, 0}, {0, 0, 0.2}}}};
    const double dt = 0.5 / steps;
    Mat3 h = identity();
    const StepMotion step = plan_motion(dt, 0, 0, gradient, gradient);
    Grain grain{{0.4, 0.7, 0.2}, gradient * Vec3{0.4, 0.7, 0.2}, {}};
    for (int k = 0; k < steps; ++k) {
        h += dt * (gradient * h);
        grain = moved(step, grain, {}, {});
    }
    return norm(inverse(h) * grain.position - Vec3{0.4, 0.7, 0.2});
}

TEST(Integrator, AFreeGrainKeepsItsPlaceInADeformingCellToFirstOrder) {
    EXPECT_LT(drift(1000), 1e-3);
    EXPECT_NEAR(drift(1000) / drift(2000), 2, 0.02);
}

} // namespace
} // namespace suffuse::motion
