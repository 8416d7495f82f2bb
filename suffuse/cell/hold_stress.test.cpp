#include "suffuse/cell/hold_stress.hpp"

#include <gtest/gtest.h>

namespace suffuse::cell {
namespace {

TEST(HoldStress, IsWhatALoadingGaveAnAxisElseWhatItHasLedTo) {
    ServoState state;
    state.stress = {1.01e5, 2e5, 3e5};
    state.held_stress = {7, 7, 7}; // of an older stage
    Loading loading;
    loading.axis[0] = {Control::Stress, 1e5};
    loading.axis[1] = {Control::MeanStress, 1e5};
    hold_stress(loading, state);
    EXPECT_EQ(state.held_stress, Vec3(1e5, 2e5, 3e5));
    loading.velocity_gradient = Mat3{};
    hold_stress(loading, state);
    EXPECT_EQ(state.held_stress, state.stress);
}

} // namespace
} // namespace suffuse::cell
