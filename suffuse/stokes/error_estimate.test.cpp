#include "suffuse/stokes/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::stokes {
namespace {

TEST(ErrorEstimate, BoundsWhatGainsThatFallEvenlyLeave) {
    for (const double factor : {0.5, 0.8, 0.95}) {
        ErrorEstimate estimate(100);
        double left = 1 / (1 - factor), gain = 1;
        for (int i = 0; i < 100; ++i, gain *= factor) {
            estimate.add(gain);
            left -= gain;
        }
        EXPECT_GE(estimate.square(), 0.99 * left) << factor;
        EXPECT_LT(std::sqrt(estimate.square()), std::pow(factor, -10.0) * 1.1 * std::sqrt(gain / (1 - factor)))
            << factor;
    }
}

TEST(ErrorEstimate, BoundsASlowPartThatAFastOneHides) {
    ErrorEstimate estimate(400);
    double left = 0;
    const auto gain = [](int i) { return std::pow(0.8, i) + 1e-4 * std::pow(0.98, i); };
    for (int i = 0; i < 4000; ++i) {
        left += gain(i);
    }
    for (int i = 0; i < 300; ++i) {
        estimate.add(gain(i));
        left -= gain(i);
        if (i > 11) { // where the slow part begins to show, too small by less than two in the norm
            EXPECT_GT(estimate.square(), 0.25 * left) << i;
        }
    }
}

TEST(ErrorEstimate, SaysNothingTooEarly) {
    ErrorEstimate estimate(20);
    for (int i = 0; i < 11; ++i) {
        estimate.add(1e-9);
        EXPECT_TRUE(std::isinf(estimate.square()));
    }
}

} // namespace
} // namespace suffuse::stokes
