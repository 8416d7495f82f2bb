#include "suffuse/stokes/held_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace suffuse::stokes {
namespace {

const Grid grid{{32, 30, 36}, {1.0 / 32, 1.0 / 30, 1.0 / 36}};
const std::vector<Vec3> position{{0.31, 0.42, 0.97}};
const std::vector<double> radius{0.35};

/// Place of a face, off the center of the grain by the shortest way.
Vec3 offset(int axis, std::size_t row, std::size_t z) {
    const std::size_t x = row / grid.boxes[1], y = row % grid.boxes[1];
    Vec3 at{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    for (int a = 0; a < 3; ++a) {
        at[a] = (at[a] + (a == axis ? 0 : 0.5)) * grid.spacing[a] - position[0][a];
        at[a] -= std::round(at[a]);
    }
    return at;
}

TEST(HeldFaces, AreThoseInAGrainAndThoseWithASurfaceBeforeTheNextFace) {
    const std::array<HeldFaces, 3> all = find_held_faces(grid, position, radius);
    const double reach = 1.0 / 30;
    for (int axis = 0; axis < 3; ++axis) {
        const HeldFaces& faces = all[static_cast<std::size_t>(axis)];
        std::size_t within = 0;
        for (std::size_t row = 0; row < grid.rows(); ++row) {
            for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
                const double distance = norm(offset(axis, row, faces.z[f])) - radius[0];
                EXPECT_LT(distance, reach);
                EXPECT_EQ(faces.mobility[f] > 0, distance >= 0);
                within += distance < 0 ? 1 : 0;
            }
        }
        const double volume = 4.0 / 3 * std::numbers::pi * std::pow(radius[0], 3);
        EXPECT_NEAR(static_cast<double>(within) / static_cast<double>(grid.size()), volume, 0.01 * volume);
    }
}

TEST(HeldFaces, AreOfTheNearestGrain) {
    const std::vector<Vec3> two{{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    const std::vector<double> radii{0.26, 0.24};
    const HeldFaces faces = find_held_faces(grid, two, radii)[1];
    for (std::size_t row = 0; row < grid.rows(); ++row) {
        const std::size_t x = row / grid.boxes[1], y = row % grid.boxes[1];
        for (std::size_t f = faces.row_begin[row]; f < faces.row_begin[row + 1]; ++f) {
            const Vec3 at{
                (static_cast<double>(x) + 0.5) * grid.spacing.x, static_cast<double>(y) * grid.spacing.y,
                (static_cast<double>(faces.z[f]) + 0.5) * grid.spacing.z};
            const double first = norm(at - two[0]) - radii[0], second = norm(at - two[1]) - radii[1];
            if (std::abs(first - second) > 1e-6 && std::min(first, second) < 0) {
                EXPECT_EQ(faces.grain[f], first < second ? 0U : 1U);
            }
        }
    }
}

} // namespace
} // namespace suffuse::stokes
