#include "suffuse/dem/bounds.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <limits>

namespace suffuse::dem {
namespace {

constexpr double radius = 1e-4; // [m]

void expect_in(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

std::string error_of(const World& world, const StepPlan& plan, const Mat3& stress, const MotionBefore& before) {
    try {
        check_motion(world, plan, 50, stress, before);
    } catch (const StateError& error) {
        return error.what();
    }
    return "";
}

/// Two grains that touch, at rest under 100 kPa.
struct Rest {
    World world = test::two_grains(radius, radius, 1e-3 * radius, {});
    StepPlan plan;

    Rest() {
        test::add_contact(world, 0, 1);
        world.clock.step = 120;
        world.servo.stress = {1e5, 1e5, 1e5};
        plan.dt = 1e-8;
        for (cell::AxisControl& axis : plan.loading.axis) {
            axis = {cell::Control::Stress, 1e5};
        }
    }
};

TEST(MotionBound, NamesTheGrainThatSpinsBeyondAllThatTheLoadingGives) {
    Rest rest;
    const MotionBefore before = look_before(rest.world, false);
    EXPECT_GT(before.speed, 0.1); // [m/s]: the spring could let go
    EXPECT_EQ(error_of(rest.world, rest.plan, diagonal({1e5, 1e5, 1e5}), before), "");
    rest.world.grains.id[1] = 17;
    rest.world.grains.spin[1] = {0, 1.1 * most_speed * before.speed / radius, 0};
    const std::string spun = error_of(rest.world, rest.plan, diagonal({1e5, 1e5, 1e5}), before);
    for (const char* part : {"at step 120 grain 17 ", "rad/s", "a smaller time step than 1e-08 s"}) {
        expect_in(spun, part);
    }
}

TEST(MotionBound, LetsAGrainGoAsFastAsALoadDrivesIt) {
    Rest rest;
    grains::GrainLoad load;
    const double speed = 1e3, time = 50 * rest.plan.dt; // [m/s], [s]
    load.force = {{}, {rest.world.grains.mass[1] * speed / time, 0, 0}};
    rest.world.grains.velocity[1] = {speed, 0, 0};
    const MotionBefore before{1e-3, {}};
    EXPECT_NE(error_of(rest.world, rest.plan, {}, before), "");
    rest.plan.load = &load;
    EXPECT_EQ(error_of(rest.world, rest.plan, {}, before), "");
}

TEST(MotionBound, StopsAStressThatIsFarBeyondTheHeldOneAndRises) {
    Rest rest;
    const MotionBefore before = look_before(rest.world, false);
    const Mat3 risen = diagonal({1e5, 1.1 * most_stress * 1e5, 1e5});
    expect_in(error_of(rest.world, rest.plan, risen, before), "1.1e+04 kPa along y");
    expect_in(error_of(rest.world, rest.plan, risen, before), "100 kPa are held");
    MotionBefore pressed = before;
    pressed.stress = Vec3{1e5, 2 * most_stress * 1e5, 1e5}; // put so, and being let go
    EXPECT_EQ(error_of(rest.world, rest.plan, risen, pressed), "");
    EXPECT_EQ(error_of(rest.world, rest.plan, risen, look_before(rest.world, true)), "");
    rest.plan.loading.axis[1] = {}; // held in place: its stress is not controlled
    EXPECT_EQ(error_of(rest.world, rest.plan, risen, before), "");
}

TEST(MotionBound, EndsABurstWhoseStepIsTooLong) {
    World world = test::two_grains(radius, radius, 1e-3 * radius, {});
    world.material.rolling_friction = -1;
    world.material.adhesion_normal = world.material.adhesion_shear = 1e12; // a disturbance cannot part them
    StepCaches caches;
    step(world, caches, test::plan_of(1e-12));
    world.grains.spin[0].y = 1;
    const double limit = 2 / highest_frequency(world, 2000);
    World calm = world;
    EXPECT_NO_THROW(advance(calm, caches, test::plan_of(0.95 * limit), 500));
    StepCaches others;
    EXPECT_THROW(advance(world, others, test::plan_of(1.1 * limit), 50), StateError);
}

TEST(MotionBound, NamesTheGrainThatSomebodySetToNoNumber) {
    World world = test::two_grains(radius, radius, 1e-3 * radius, {});
    world.grains.velocity[1].z = std::numeric_limits<double>::quiet_NaN();
    StepCaches caches;
    try {
        advance(world, caches, test::plan_of(1e-9), 50);
        FAIL();
    } catch (const StateError& error) {
        expect_in(error.what(), fmt::format("velocity or spin of grain {} is not a number", world.grains.id[1]));
    }
}

} // namespace
} // namespace suffuse::dem
