#include "suffuse/run/control.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"
#include <cmath>
#include <optional>
#include <vector>

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
    options.progress_interval = -1; // each beat is shown
    options.on_progress = [&](const Progress& progress) {
        if (!progress.state.is_null()) {
            shown = progress.state.at("axial_strain");
        }
    };
    Overview overview(options);
    Control control(overview, 1e9);
    control.begin({});
    if (axis) {
        control.show_strain_of(*axis);
    }
    control.beat("shear", 1, &world);
    return shown;
}

TEST(Control, ShowsTheStrainOfTheAxisThatIsCompressed) {
    EXPECT_NEAR(shown_strain(0), -std::log(0.98), 1e-15); // rounding
    EXPECT_NEAR(shown_strain(2), -std::log(1.01), 1e-15);
    EXPECT_EQ(shown_strain({}), shown_strain(2));
}

TEST(Control, ShowsOtherNumbersOfAStageFromTheNextBeatOnUntilTheStageEnds) {
    std::vector<nlohmann::json> shown;
    RunOptions options;
    options.progress_interval = -1; // each beat is shown
    options.on_progress = [&](const Progress& progress) { shown.push_back(progress.state); };
    Overview overview(options);
    Control control(overview, 1e9);
    control.begin({});
    control.show_numbers({{"mobility", 1}});
    control.beat("ramp", 1);
    control.beat("ramp", 2);
    control.begin({});
    ASSERT_EQ(shown.size(), 4U);
    EXPECT_TRUE(shown[0].is_null());
    EXPECT_EQ(shown[1].at("mobility"), 1);
    EXPECT_EQ(shown[2].at("mobility"), 1);
    EXPECT_TRUE(shown[3].is_null());
}

} // namespace
} // namespace suffuse::run
