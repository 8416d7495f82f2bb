#include "suffuse/stokes/response.hpp"

#include "suffuse/base/parallel.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace suffuse::stokes {
namespace {

using Field = std::array<std::vector<double>, 3>;

const Grid uneven{{6, 20, 18}, {0.5, 0.3, 0.4}};

Field zero(const Grid& grid) {
    Field field;
    field.fill(std::vector<double>(grid.size()));
    return field;
}

Field random_force(const Grid& grid) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> value(-1, 1);
    Field force = zero(grid);
    for (std::vector<double>& component : force) {
        double mean = 0;
        for (double& f : component) {
            f = value(random);
            mean += f / static_cast<double>(grid.size());
        }
        for (double& f : component) {
            f -= mean;
        }
    }
    return force;
}

template <class Real>
Field response_to(const Grid& grid, const Field& force) {
    Response response(grid);
    Field velocity = zero(grid);
    const std::size_t nz = grid.boxes[2];
    response.apply(
        RowWork<Real>([&](std::size_t axis, std::size_t row, std::span<Real> values) {
            for (std::size_t z = 0; z < nz; ++z) {
                values[z] = static_cast<Real>(force[axis][row * nz + z]);
            }
        }),
        RowWork<Real>([&](std::size_t axis, std::size_t row, std::span<Real> values) {
            for (std::size_t z = 0; z < nz; ++z) {
                velocity[axis][row * nz + z] = static_cast<double>(values[z]);
            }
        })
    );
    return velocity;
}

/// Index of a box some boxes further along an axis.
std::size_t shifted(const Grid& grid, std::size_t box, std::size_t axis, std::size_t by) {
    std::array<std::size_t, 3> at{
        box / grid.boxes[2] / grid.boxes[1], box / grid.boxes[2] % grid.boxes[1], box % grid.boxes[2]};
    at[axis] = (at[axis] + by) % grid.boxes[axis];
    return (at[0] * grid.boxes[1] + at[1]) * grid.boxes[2] + at[2];
}

double before(const Grid& grid, const std::vector<double>& f, std::size_t box, std::size_t axis) {
    return f[shifted(grid, box, axis, grid.boxes[axis] - 1)];
}

double after(const Grid& grid, const std::vector<double>& f, std::size_t box, std::size_t axis) {
    return f[shifted(grid, box, axis, 1)];
}

double divergence(const Grid& grid, const Field& u, std::size_t box) {
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        sum += (after(grid, u[a], box, a) - u[a][box]) / grid.spacing[static_cast<int>(a)];
    }
    return sum;
}

double laplacian(const Grid& grid, const std::vector<double>& f, std::size_t box) {
    double sum = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const double h = grid.spacing[static_cast<int>(a)];
        sum += (after(grid, f, box, a) - 2 * f[box] + before(grid, f, box, a)) / (h * h);
    }
    return sum;
}

double product(const Field& a, const Field& b) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < a[axis].size(); ++i) {
            sum += a[axis][i] * b[axis][i];
        }
    }
    return sum;
}

TEST(Response, IsTheSineOfAShearingForceOverTheSquareOfItsWaveNumber) {
    const Grid grid{{8, 12, 10}, {0.5, 0.25, 0.4}};
    Field force = zero(grid);
    const auto sine = [&](std::size_t box) {
        return std::sin(2 * std::numbers::pi * static_cast<double>(box / grid.boxes[2] % grid.boxes[1]) / 12);
    };
    for (std::size_t box = 0; box < grid.size(); ++box) {
        force[0][box] = sine(box);
    }
    const Field velocity = response_to<double>(grid, force);
    const double k = 2 * std::sin(std::numbers::pi / 12) / 0.25; // of the grid's differences
    for (std::size_t box = 0; box < grid.size(); ++box) {
        EXPECT_NEAR(velocity[0][box], sine(box) / (k * k), 1e-14);
        EXPECT_NEAR(velocity[1][box], 0, 1e-14);
        EXPECT_NEAR(velocity[2][box], 0, 1e-14);
    }
}

TEST(Response, SolvesTheDifferenceEquationsUpToAPressure) {
    const Field force = random_force(uneven), velocity = response_to<double>(uneven, force);
    Field rest = force; // a gradient: its difference from one without sources is free of them everywhere
    for (std::size_t box = 0; box < uneven.size(); ++box) {
        EXPECT_NEAR(divergence(uneven, velocity, box), 0, 1e-13);
        for (std::size_t a = 0; a < 3; ++a) {
            rest[a][box] += laplacian(uneven, velocity[a], box);
        }
    }
    for (std::size_t box = 0; box < uneven.size(); ++box) {
        for (std::size_t a = 0; a < 3; ++a) { // no curl
            const std::size_t b = (a + 1) % 3;
            const double along = (rest[b][box] - before(uneven, rest[b], box, a)) / uneven.spacing[static_cast<int>(a)];
            const double across =
                (rest[a][box] - before(uneven, rest[a], box, b)) / uneven.spacing[static_cast<int>(b)];
            EXPECT_NEAR(along, across, 1e-11);
        }
    }
}

TEST(Response, IsSymmetricAndTakesPower) {
    const Field a = random_force(uneven);
    Field b = zero(uneven);
    b[1][7] = 1;
    const Field to_a = response_to<double>(uneven, a), to_b = response_to<double>(uneven, b);
    EXPECT_NEAR(product(a, to_b), product(b, to_a), 1e-13);
    EXPECT_GT(product(a, to_a), 0);
}

TEST(Response, OfSinglePrecisionIsThatOfDoubleToItsRounding) {
    const Field force = random_force(uneven), exact = response_to<double>(uneven, force);
    Field difference = response_to<float>(uneven, force);
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t i = 0; i < uneven.size(); ++i) {
            difference[a][i] -= exact[a][i];
        }
    }
    EXPECT_LT(std::sqrt(product(difference, difference) / product(exact, exact)), 1e-6);
}

TEST(Response, HasTheSameBitsForAnyNumberOfThreads) {
    const int before = thread_count();
    const Field force = random_force(uneven);
    set_thread_count(1);
    const Field one = response_to<float>(uneven, force);
    set_thread_count(3);
    const Field three = response_to<float>(uneven, force);
    set_thread_count(before);
    EXPECT_EQ(one, three);
}

} // namespace
} // namespace suffuse::stokes
