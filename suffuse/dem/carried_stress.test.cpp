#include "suffuse/dem/carried_stress.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/inspect.hpp"

#include <gtest/gtest.h>

#include "tests/support/worlds.hpp"

namespace suffuse::dem {
namespace {

TEST(CarriedStress, IsTheMeanStressOrAnErrorThatSaysWhoNeedsIt) {
    EXPECT_DOUBLE_EQ(require_pressure({}, diagonal({1e5, 2e5, 3e5}), "a test needs a sample"), 2e5);
    for (const double pulled : {0.0, -5e3}) {
        try {
            require_pressure({}, diagonal({pulled, pulled, pulled}), "a test needs a sample");
            FAIL() << "a sample without stress was taken";
        } catch (const StateError& error) {
            EXPECT_EQ(std::string(error.what()).find("a test needs a sample that carries a stress"), 0U);
        }
    }
}

TEST(CarriedStress, OfGrainsFarWithinOneAnotherIsRefused) {
    World world = test::reference_packing("packing500");
    world.cell.h = 0.6 * world.cell.h;
    for (Vec3& position : world.grains.position) {
        position *= 0.6;
    }
    add_first_contacts(world);
    try {
        require_pressure(world, mean_stress_tensor(world), "a test needs a sample");
        FAIL() << "its void ratio is " << void_ratio(world);
    } catch (const StateError& error) {
        EXPECT_NE(
            std::string(error.what()).find("of the smaller radius in the mean, at a void ratio of -0."),
            std::string::npos
        ) << error.what();
    }
}

} // namespace
} // namespace suffuse::dem
