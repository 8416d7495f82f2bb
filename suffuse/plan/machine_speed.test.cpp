#include "suffuse/plan/machine_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::plan {
namespace {

TEST(MachineSpeed, IsMeasuredOnAboutAsManyGrainsAsRequested) {
    const MachineSpeed speed = measure_speed(1000, dem::Mode::Reference, 0.02);
    EXPECT_EQ(speed.grains, 1000); // 10 x 10 x 10
    EXPECT_GT(speed.particle_steps_per_second, 0);
    EXPECT_TRUE(std::isfinite(speed.particle_steps_per_second));
}

} // namespace
} // namespace suffuse::plan
