#include "suffuse/stokes/held_forces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace suffuse::stokes {
namespace {

const Grid grid{{16, 20, 18}, {1.0 / 16, 1.1 / 20, 1.2 / 18}};
const std::vector<Vec3> position{{0.2, 0.3, 0.4}, {0.7, 0.8, 0.9}};
const std::vector<double> radius{0.33, 0.21};

template <class Values>
double product(const FaceValues<double>& a, const Values& b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t f = 0; f < a[axis].size(); ++f) {
            sum += a[axis][f] * static_cast<double>(b[axis][f]);
        }
    }
    return sum;
}

FaceValues<double> random_values(const HeldForces& held, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    FaceValues<double> values;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        values[axis].resize(held.faces()[axis].size());
        for (double& v : values[axis]) {
            v = value(random);
        }
    }
    return values;
}

FaceValues<float> preconditioned(HeldForces& held, const FaceValues<double>& values) {
    FaceValues<float> result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        result[axis].resize(values[axis].size());
    }
    held.precondition(values, result);
    return result;
}

UnitFlow flow_along(const Vec3& direction, double tolerance) {
    return HeldForces(grid, position, radius).solve({&direction, 1}, {tolerance, 2000}, {}).front();
}

TEST(HeldForces, PreconditionerIsSymmetricAndPositive) {
    HeldForces held(grid, position, radius);
    const FaceValues<double> a = random_values(held, 1), b = random_values(held, 2);
    const FaceValues<float> of_a = preconditioned(held, a), of_b = preconditioned(held, b);
    const double scale = product(a, of_a);
    EXPECT_GT(scale, 0);
    EXPECT_NEAR(product(a, of_b), product(b, of_a), 1e-6 * scale); // single precision
    FaceValues<double> even = a;
    for (std::vector<double>& values : even) {
        values.assign(values.size(), 1);
    }
    EXPECT_GT(product(even, preconditioned(held, even)), 0);
}

TEST(HeldForces, VelocitiesAreSymmetricInTheForcesAndTakePower) {
    HeldForces held(grid, position, radius);
    const FaceValues<double> a = random_values(held, 1), b = random_values(held, 2);
    FaceValues<double> of_a = a, of_b = b;
    held.find_velocities(a, of_a);
    held.find_velocities(b, of_b);
    const double scale = product(a, of_a);
    EXPECT_GT(scale, 0);
    EXPECT_NEAR(product(a, of_b), product(b, of_a), 1e-12 * scale);
}

TEST(HeldForces, ResidualBoundsTheErrorsOfPermeabilityAndForces) {
    const UnitFlow exact = flow_along({1, 0, 0}, 1e-10);
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const UnitFlow flow = flow_along({1, 0, 0}, tolerance);
        EXPECT_LE(flow.residual, tolerance);
        EXPECT_LT(flow.velocity.x / exact.velocity.x - 1, tolerance);
        EXPECT_GT(flow.velocity.x / exact.velocity.x - 1, -1e-8); // from above
        for (std::size_t g = 0; g < radius.size(); ++g) {
            EXPECT_LT(norm(flow.force[g] - exact.force[g]), 2 * std::sqrt(tolerance) * norm(exact.force[g]))
                << tolerance;
        }
    }
}

TEST(HeldForces, VelocitiesAcrossTheDriveAreExactToTheSecondOrderToo) {
    const std::vector<Vec3> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    HeldForces held(grid, position, radius);
    const std::vector<UnitFlow> exact = held.solve(axes, {1e-10, 2000}, {}), flow = held.solve(axes, {1e-4, 2000}, {});
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            const auto at = static_cast<std::size_t>(b);
            EXPECT_NEAR(flow[at].velocity[a], exact[at].velocity[a], 1e-4 * exact[0].velocity.x);
        }
    }
}

TEST(HeldForces, AddUpToWhatDrivesTheWater) {
    const UnitFlow flow = flow_along({0.6, 0, -0.8}, 1e-3);
    const double volume = 1.1 * 1.2;
    EXPECT_LT(norm(flow.force[0] + flow.force[1] - volume * Vec3{0.6, 0, -0.8}), 1e-13 * volume);
}

} // namespace
} // namespace suffuse::stokes
