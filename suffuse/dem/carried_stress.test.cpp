#include "suffuse/dem/carried_stress.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

namespace suffuse::dem {
namespace {

TEST(CarriedStress, IsTheMeanStressOrAnErrorThatSaysWhoNeedsIt) {
    EXPECT_DOUBLE_EQ(require_pressure(diagonal({1e5, 2e5, 3e5}), "a test needs a sample"), 2e5);
    for (const double pulled : {0.0, -5e3}) {
        try {
            require_pressure(diagonal({pulled, pulled, pulled}), "a test needs a sample");
            FAIL() << "a sample without stress was taken";
        } catch (const StateError& error) {
            EXPECT_EQ(std::string(error.what()).find("a test needs a sample that carries a stress"), 0U);
        }
    }
}

} // namespace
} // namespace suffuse::dem
