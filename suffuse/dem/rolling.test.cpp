// A grain that slides and rolls on a held grain so large that it is a plane, pressed on by a constant force: the closed
// forms of a sphere on a floor and on an incline.

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <algorithm>
#include <string>

namespace suffuse::dem {
namespace {

constexpr double radius = 1e-4;           // of the grain [m]
constexpr double floor_radius = 1;        // ten thousand times that [m]
constexpr double sinking = 1e-6 * radius; // overlap under the load [m]

struct Floor {
    World world;
    StepPlan plan;
    grains::GrainLoad load;
    StepCaches caches;
    double pull = 0; ///< load over mass: the "gravity" [m/s2]

    /// The load leans by `angle` [rad] towards +x: a floor that slopes down that way.
    explicit Floor(const grains::Material& material, double angle = 0, double damping = 0) {
        world = test::empty_world(5 * floor_radius, material);
        test::add(world, {0, 0, -floor_radius}, floor_radius);
        world.grains.motion[0] = grains::Motion::Held;
        const double kn = 2 * material.modulus * radius * floor_radius / (radius + floor_radius);
        const double normal = kn * sinking, weight = normal / std::cos(angle);
        test::add(world, {0, 0, radius - sinking}, radius);
        load.force = {{}, weight * Vec3{std::sin(angle), 0, -std::cos(angle)}};
        pull = weight / world.grains.mass[1];
        const double omega = std::sqrt(kn / world.grains.mass[1]);
        plan = test::plan_of(0.05 / omega, damping); // far below the stability limit: shear is the faster mode
        plan.load = &load;
    }

    Floor(const Floor&) = delete;

    void run(double time) { test::advance(world, caches, plan, static_cast<std::int64_t>(time / plan.dt)); }

    [[nodiscard]] double speed() const { return world.grains.velocity[1].x; }

    /// Means over `time` of the speed and of the speed of the surface, so that the contact's own vibration drops out.
    [[nodiscard]] std::pair<double, double> mean_speeds(double time) {
        const auto steps = static_cast<std::int64_t>(time / plan.dt);
        double v = 0, w = 0;
        for (std::int64_t k = 0; k < steps; ++k) {
            step(world, caches, plan);
            v += speed() / static_cast<double>(steps);
            w += radius * world.grains.spin[1].y / static_cast<double>(steps);
        }
        return {v, w};
    }
};

grains::Material without_rolling(double tan_friction) {
    grains::Material material;
    material.friction = std::atan(tan_friction);
    material.rolling_stiffness = 0;
    return material;
}

TEST(Rolling, ASlidingGrainEndsRollingAtFiveSeventhsOfItsSpeed) {
    constexpr double start = 1, mu = 0.5; // [m/s], [-]
    Floor floor(without_rolling(mu));
    floor.world.grains.velocity[1].x = start;
    const double rolls_after = 2 * start / (7 * mu * floor.pull);
    floor.run(0.5 * rolls_after);
    // Still sliding: friction alone brakes. The floor's curvature turns the load by 1e-4 of a radian here.
    EXPECT_NEAR(floor.speed() / (start - 0.5 * mu * floor.pull * rolls_after), 1, 1e-3);
    floor.run(0.6 * rolls_after);
    const auto [v, w] = floor.mean_speeds(0.1 * rolls_after);
    EXPECT_NEAR(v / (5.0 / 7 * start), 1, 1e-3);
    EXPECT_NEAR(w / v, 1, 1e-3);
    RecordProperty("final_speed_error", std::to_string(v / (5.0 / 7 * start) - 1));
}

TEST(Rolling, DownAnInclineTheGrainRollsWithFiveSeventhsOfThePull) {
    const double angle = 0.3;
    Floor floor(without_rolling(0.8), angle);
    floor.run(1e-4);
    const double first = floor.mean_speeds(1e-5).first;
    floor.run(1e-4);
    const double last = floor.mean_speeds(1e-5).first, acceleration = (last - first) / 1.1e-4;
    EXPECT_NEAR(acceleration / (5.0 / 7 * floor.pull * std::sin(angle)), 1, 2e-3); // whole steps, vibration
    RecordProperty("error", std::to_string(acceleration / (5.0 / 7 * floor.pull * std::sin(angle)) - 1));
}

TEST(Rolling, OnASlipperyInclineTheGrainSlides) {
    const double angle = 1.0, mu = 0.2; // 2/7 tan(angle) = 0.44
    Floor floor(without_rolling(mu), angle);
    floor.run(1e-4);
    const double first = floor.mean_speeds(1e-5).first;
    floor.run(1e-4);
    const double acceleration = (floor.mean_speeds(1e-5).first - first) / 1.1e-4;
    const double expected = floor.pull * (std::sin(angle) - mu * std::cos(angle));
    EXPECT_NEAR(acceleration / expected, 1, 2e-3);
    RecordProperty("error", std::to_string(acceleration / expected - 1));
}

/// Rolling resistance as on the floor: the stiffness brought down so that kr is that of two equal grains.
grains::Material with_rolling_limit(double eta) {
    grains::Material material = without_rolling(0.9);
    material.rolling_stiffness = 2 * radius / floor_radius;
    material.rolling_friction = eta;
    return material;
}

TEST(RollingLimit, HoldsTheGrainOnAnInclineUpToItsTangent) {
    const double eta = 0.3;
    Floor floor(with_rolling_limit(eta), std::atan(0.9 * eta), 0.2);
    floor.run(5e-4);
    EXPECT_LT(std::abs(floor.speed()), 1e-9);
    EXPECT_LT(std::abs(floor.world.grains.position[1].x), 1e-2 * radius);
}

TEST(RollingLimit, LetsTheGrainRollWithWhatThePullHasBeyondIt) {
    const double eta = 0.3, angle = std::atan(2 * eta);
    Floor floor(with_rolling_limit(eta), angle);
    floor.run(1e-4);
    const double first = floor.mean_speeds(1e-5).first;
    floor.run(1e-4);
    const double acceleration = (floor.mean_speeds(1e-5).first - first) / 1.1e-4;
    const double expected = 5.0 / 7 * floor.pull * (std::sin(angle) - eta * std::cos(angle));
    EXPECT_NEAR(acceleration / expected, 1, 5e-3);
    RecordProperty("error", std::to_string(acceleration / expected - 1));
}

/// Frequencies of a grain on an equal one that is held, `y` the tangential motion and `turn` about z: slip is y - r
/// turn.
struct RollingModes {
    double low = 0, high = 0, turn_over_shift = 0; ///< of the low mode [rad/s], [rad/m]
};

RollingModes rolling_modes(double ks, double kr, double m, double i) {
    // det [[ks - m w2, -ks r], [-ks r, ks r2 + kr - i w2]] = 0
    const double r = radius, a = m * i, b = m * (ks * r * r + kr) + i * ks, c = ks * kr;
    const double root = std::sqrt(b * b - 4 * a * c), low2 = 2 * c / (b + root), high2 = (b + root) / (2 * a);
    return {std::sqrt(low2), std::sqrt(high2), (ks - m * low2) / (ks * r)};
}

TEST(RollingSpring, SwingsAtTheFrequencyOfTheGrainOnItsSpring) {
    for (const double alpha : {0.01, 7.5}) {
        grains::Material material;
        material.friction = 1.5;
        material.rolling_stiffness = alpha;
        material.rolling_friction = -1;
        World world = test::two_grains(radius, radius, sinking, material);
        world.grains.motion[0] = grains::Motion::Held;
        const double kn = material.modulus * radius, ks = material.shear_ratio * kn, kr = alpha * ks * radius * radius;
        const RollingModes modes = rolling_modes(ks, kr, world.grains.mass[1], world.grains.inertia[1]);
        grains::GrainLoad load{{{}, {-kn * sinking, 0, 0}}};
        StepPlan plan = test::plan_of(0.02 / modes.high);
        plan.load = &load;
        // The low mode alone, so small that the normal does not turn; one quarter of a swing from rest to the middle.
        const double size = 1e-5;
        world.grains.velocity[1].y = size;
        world.grains.spin[1].z = size * modes.turn_over_shift;
        StepCaches caches;
        int crossings = 0;
        double first = 0, last = 0, before = size;
        while (crossings < 21) {
            step(world, caches, plan);
            const double v = world.grains.velocity[1].y;
            if (v * before < 0) { // between two steps, by a straight line
                const double time = world.clock.time - plan.dt * v / (v - before);
                (crossings == 0 ? first : last) = time;
                ++crossings;
            }
            before = v;
        }
        const double frequency = 20 * pi / (last - first);
        EXPECT_NEAR(frequency / modes.low, 1, 1e-3) << alpha; // the pair leans over by its overlap, 1e-6; step 1e-4
        RecordProperty(
            alpha < 1 ? "soft_error" : "stiff_error", std::to_string(1e6 * (frequency / modes.low - 1)) + "e-6"
        );
        if (alpha < 1) { // slip does not matter: kr against the inertia about the contact
            const double inertia = 1.4 * world.grains.mass[1] * radius * radius;
            EXPECT_NEAR(frequency / std::sqrt(kr / inertia), 1, 0.01);
        }
    }
}

} // namespace
} // namespace suffuse::dem
