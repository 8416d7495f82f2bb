#include "suffuse/io/mean_motion.hpp"

#include "suffuse/io/packing_checks.hpp"
#include "suffuse/io/packing_export.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"

namespace suffuse::io {
namespace {

const Mat3 shear{{{{0.5, 0, 50}, {3, 0, 0}, {0, 0, -1}}}};

/// Grains on a lattice that move with the gradient, and by `rattle` this way and that.
grains::Grains moving_grains(const Mat3& gradient, double rattle) {
    grains::Grains grains;
    for (int k = 0; k < 125; ++k) {
        const Vec3 x{k % 5 + 0.5, k / 5 % 5 + 0.5, k / 25 + 0.5};
        const auto g = grains::add_grain(grains, x, 0.5, 2600);
        grains.velocity[g] = gradient * x + rattle * Vec3{k % 3 - 1.0, k % 7 - 3.0, k % 2 - 0.5};
    }
    return grains;
}

TEST(MeanMotion, IsTheGradientThatTheGrainsMoveWith) {
    const auto found = find_velocity_gradient(moving_grains(shear, 0));
    ASSERT_TRUE(found);
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR((*found)(i, j), shear(i, j), 1e-11); // rounding of sums of a hundred times 250
        }
    }
    const auto rattled = find_velocity_gradient(moving_grains(shear, 5)); // a scatter of 5 against one of 70
    ASSERT_TRUE(rattled);
    EXPECT_NEAR((*rattled)(0, 2), 50, 2);
}

TEST(MeanMotion, NoneShowsWhereGrainsRestOrRattleOrLieInAPlane) {
    EXPECT_FALSE(find_velocity_gradient(moving_grains({}, 0)));
    EXPECT_FALSE(find_velocity_gradient(moving_grains({}, 5)));
    grains::Grains flat = moving_grains(shear, 0);
    for (Vec3& x : flat.position) {
        x.z = 1;
    }
    EXPECT_FALSE(find_velocity_gradient(flat));
}

TEST(MeanMotion, IsKeptOnceWhenAPackingIsWrittenAndReadBack) {
    const test::TempFolder folder;
    export_csv(folder / "p.csv", moving_grains(shear, 0));
    PackingRequest request{.file = folder / "p.csv"};
    request.cell = diagonal({5, 5, 5});
    const TakenPacking found = take_packing(request);
    EXPECT_NEAR(found.velocity_gradient(0, 2), 50, 1e-11);
    EXPECT_NE(found.warnings.at(1).find("velocity_gradient says another one"), std::string::npos);
    request.velocity_gradient = Mat3{};
    EXPECT_EQ(take_packing(request).velocity_gradient, Mat3{}); // as the caller says
}

} // namespace
} // namespace suffuse::io
