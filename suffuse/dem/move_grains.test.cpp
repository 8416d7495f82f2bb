// How grains move by what acts on them: closed forms of the leapfrog, the watch, and sleepers who catch up.

#include "suffuse/dem/move_grains.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

constexpr double dt = 1e-6;                         // [s]
const Vec3 start{0.25, 0.5, 0.75}, speed{1, -2, 4}; // [m], [m/s]: powers of two keep the closed forms exact

/// One grain alone in a cell of 1 m: no contact, so that it sleeps.
class OneGrain {
public:
    OneGrain() : world(test::empty_world(1)) {
        test::add(world, start, 0.01);
        world.grains.velocity[0] = speed;
        to_rows(world.grains, rows);
        contact::plan_sums(world.contacts, 1, plan);
        sums.resize(plan.rows());
    }

    [[nodiscard]] Vec3 position() const { return xyz(rows[0].position); }

    [[nodiscard]] Vec3 velocity() const { return xyz(rows[0].velocity); }

    /// One step with a force that acts on it [N]. @return whether it is further from its start than `allowance` [m]
    bool move(const Vec3& force, double allowance) {
        Watch watch;
        watch.grains.push_back({Float4{0, 0, 0, static_cast<float>(allowance * allowance)}});
        watch.origin.push_back(start);
        const grains::GrainLoad load{{force}};
        const GrainMove all = plan_move(
            motion::plan_motion(dt, 0, 0, {}, {}), plan, &load, 1, true, identity(), watch, false, rows, sums
        );
        return move_domain(all, 0);
    }

    World world;
    std::vector<grains::MovingRow> rows;
    std::vector<grains::GrainSum> sums;
    contact::SumPlan plan;
};

void expect_near(const Vec3& found, const Vec3& expected, double tolerance) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
    EXPECT_NEAR(found.z, expected.z, tolerance);
}

TEST(MoveGrains, AForceChangesTheSpeedAndTheNewSpeedThePlace) {
    OneGrain grain;
    const double mass = grain.world.grains.mass[0];
    const Vec3 force{3, 0, -5};
    grain.move(force, 1);
    const Vec3 expected = speed + (dt / mass) * force; // leapfrog: half a step ahead of the place
    expect_near(grain.velocity(), expected, 1e-14);
    expect_near(grain.position(), start + dt * expected, 1e-15);
}

TEST(MoveGrains, TheWatchReportsAGrainThatWentFurtherThanAllowed) {
    const double way = dt * norm(speed);
    EXPECT_FALSE(OneGrain().move({}, 1.01 * way));
    EXPECT_TRUE(OneGrain().move({}, 0.99 * way));
}

TEST(MoveGrains, SleepersCoastOnAStraightLine) {
    OneGrain grain;
    const std::vector<motion::StepMotion> steps(most_slept_steps, motion::plan_motion(dt, 0.2, 0, {}, {}));
    coast_sleepers(steps, grain.plan, grain.rows);
    expect_near(grain.position(), start + (dt * most_slept_steps) * speed, 1e-14); // a rounding a step
    EXPECT_EQ(grain.velocity(), speed) << "nothing acts on it, so nothing damps it";
}

TEST(MoveGrains, SleepersCatchUpToTheBitsOfOneStepAfterAnother) {
    for (const bool sheared : {false, true}) {
        Mat3 gradient = diagonal({-10, 5, 7}); // [1/s]
        gradient(0, 1) = sheared ? 3 : 0;
        OneGrain at_once, one_by_one;
        std::vector<motion::StepMotion> steps;
        for (int k = 0; k < 20; ++k) {
            steps.push_back(motion::plan_motion(dt, 0.2, 0, (0.1 * k) * gradient, (0.1 * (k + 1)) * gradient));
        }
        coast_sleepers(steps, at_once.plan, at_once.rows);
        for (const motion::StepMotion& step : steps) {
            coast_sleepers({&step, 1}, one_by_one.plan, one_by_one.rows);
        }
        EXPECT_EQ(at_once.position(), one_by_one.position());
        EXPECT_EQ(at_once.velocity(), one_by_one.velocity());
        EXPECT_NE(at_once.velocity(), speed) << "the mean motion carries it";
    }
}

} // namespace
} // namespace suffuse::dem
