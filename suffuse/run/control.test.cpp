#include "suffuse/run/control.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

namespace suffuse::run {
namespace {

/// The strain that a stage shows, which compresses a cell along x by 2 % and lets it widen along z by 1 %.
double shown_strain(std::optional<int> axis) {
    dem::World world = test::empty_world(1);
    test::add(world, {0.5, 0.5, 0.5}, 0.1);
    world.reference_h = world.cell.h;
    world.cell.h = diagonal({0.98, 1, 1.01});
    double shown = 0;
    RunOptions options;
    options.on_progress = [&](const Progress& progress) {
        if (!progress.state.is_null()) {
            shown = progress.state.at("axial_strain");
        }
    };
    Overview overview(options, 1, 1);
    Control control(overview, 1e9);
    control.begin({});
    if (axis) {
        control.show_strain_of(*axis);
    }
    for (int k = 0; shown == 0 && k < 1000; ++k) { // shows ten times a second
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        control.beat("shear", k, &world);
    }
    return shown;
}

TEST(Control, ShowsTheStrainOfTheAxisThatIsCompressed) {
    EXPECT_NEAR(shown_strain(0), -std::log(0.98), 1e-15); // rounding
    EXPECT_NEAR(shown_strain(2), -std::log(1.01), 1e-15);
    EXPECT_EQ(shown_strain({}), shown_strain(2));
}

} // namespace
} // namespace suffuse::run
