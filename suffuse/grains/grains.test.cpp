#include "suffuse/grains/grains.hpp"

#include <gtest/gtest.h>

#include <array>

namespace suffuse::grains {
namespace {

/// Three grains whose every column shows its row.
Grains some_grains() {
    Grains grains;
    for (std::uint32_t g = 0; g < 3; ++g) {
        const double number = g + 1;
        add_grain(grains, {number, 0, 0}, number * 1e-3, 2600);
        grains.velocity[g] = {0, number, 0};
        grains.spin[g] = {0, 0, number};
        grains.force[g] = {-number, 0, 0};
        grains.torque[g] = {0, -number, 0};
        grains.fine[g] = g == 2 ? 1 : 0;
    }
    grains.motion[1] = Motion::Held;
    return grains;
}

TEST(Grains, AddedAreSpheresAtRestWithTheNumberOfTheirRow) {
    Grains grains;
    add_grain(grains, {}, 2e-3, 2600);
    EXPECT_EQ(add_grain(grains, {1, 2, 3}, 1e-3, 2600), 1U);
    const double mass = 2600 * 4.0 / 3.0 * pi * 1e-9;
    EXPECT_DOUBLE_EQ(grains.mass[1], mass);
    EXPECT_DOUBLE_EQ(grains.inertia[1], 0.4 * mass * 1e-6);
    EXPECT_EQ(grains.velocity[1], Vec3());
    EXPECT_EQ(grains.id[1], 1U);
    EXPECT_EQ(grains.motion[1], Motion::Free);
    EXPECT_DOUBLE_EQ(solid_volume(grains), 4.0 / 3.0 * pi * (8e-9 + 1e-9));
}

TEST(Grains, SelectedKeepAllThatIsTheirs) {
    Grains grains = some_grains();
    const Grains before = grains;
    select_rows(grains, std::array{2U, 0U});
    for_each_column(grains, [](const auto& column) { EXPECT_EQ(column.size(), 2U); });
    EXPECT_EQ(grains.id, (std::vector<std::uint32_t>{2, 0}));
    for (std::size_t row = 0; row < 2; ++row) {
        const std::size_t was = grains.id[row];
        EXPECT_EQ(grains.position[row], before.position[was]);
        EXPECT_EQ(grains.velocity[row], before.velocity[was]);
        EXPECT_EQ(grains.spin[row], before.spin[was]);
        EXPECT_EQ(grains.force[row], before.force[was]);
        EXPECT_EQ(grains.torque[row], before.torque[was]);
        EXPECT_EQ(grains.radius[row], before.radius[was]);
        EXPECT_EQ(grains.mass[row], before.mass[was]);
        EXPECT_EQ(grains.inertia[row], before.inertia[was]);
        EXPECT_EQ(grains.motion[row], before.motion[was]);
        EXPECT_EQ(grains.fine[row], before.fine[was]);
    }
    select_rows(grains, {});
    EXPECT_EQ(grains.size(), 0U);
}

} // namespace
} // namespace suffuse::grains
