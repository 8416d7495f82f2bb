#include "suffuse/grains/moving_rows.hpp"

#include <gtest/gtest.h>

namespace suffuse::grains {
namespace {

/// More than one block of rows, every third grain held.
Grains many_grains() {
    Grains grains;
    for (std::uint32_t g = 0; g < 5000; ++g) {
        add_grain(grains, {g + 0.5, -1.0 * g, 3}, 1e-3 + 1e-7 * g, 2600);
        grains.velocity[g] = {1, g + 0.25, 2};
        grains.spin[g] = {g + 0.75, 5, 6};
        grains.motion[g] = g % 3 == 0 ? Motion::Held : Motion::Free;
    }
    return grains;
}

TEST(MovingRows, HoldWhatAStepNeedsAndNothingThatMovesAHeldGrain) {
    const Grains grains = many_grains();
    std::vector<MovingRow> rows;
    to_rows(grains, rows);
    ASSERT_EQ(rows.size(), grains.size());
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double free = g % 3 == 0 ? 0 : 1;
        ASSERT_EQ(rows[g].position[3], free / grains.mass[g]) << g;
        ASSERT_EQ(rows[g].velocity[3], free / grains.inertia[g]) << g;
        ASSERT_EQ(rows[g].spin[3], grains.radius[g]) << g;
    }
}

TEST(MovingRows, GiveTheSameBitsBackAlsoWhereTheColumnsAreGone) {
    const Grains before = many_grains();
    Grains grains = before;
    std::vector<MovingRow> rows;
    to_rows(grains, rows);
    for (std::vector<Vec3>* column : {&grains.position, &grains.velocity, &grains.spin}) {
        *column = {};
    }
    from_rows(rows, grains);
    EXPECT_EQ(grains.position, before.position);
    EXPECT_EQ(grains.velocity, before.velocity);
    EXPECT_EQ(grains.spin, before.spin);
}

TEST(MovingRows, GiveForcesAndTorquesOfTheFirstSums) {
    Grains grains = many_grains();
    std::vector<GrainSum> sums(grains.size() + 7); // parts of other domains' sums stand behind
    for (std::size_t g = 0; g < sums.size(); ++g) {
        const auto number = static_cast<double>(g);
        sums[g] = {double4({number, 1, 2}, 0), double4({3, number, 4}, 0)};
    }
    grains.force = grains.torque = {};
    from_sums(sums, grains);
    ASSERT_EQ(grains.force.size(), grains.size());
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const auto number = static_cast<double>(g);
        ASSERT_EQ(grains.force[g], Vec3(number, 1, 2));
        ASSERT_EQ(grains.torque[g], Vec3(3, number, 4));
    }
}

} // namespace
} // namespace suffuse::grains
