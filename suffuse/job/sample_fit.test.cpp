#include "suffuse/job/sample_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::job {
namespace {

/// Two strains; stress ratio and volumetric strain are measured, the mean stress is simulated alone.
LaboratoryCurve two_parts() {
    LaboratoryCurve laboratory;
    laboratory.form.grid = {0.01, 0.02};
    laboratory.values = {1, 2, 0.01, -0.04};
    laboratory.rows = {0, 1, 4, 5};
    return laboratory;
}

TEST(SampleFit, IsZeroForTheMeasuredCurveItself) {
    EXPECT_EQ(misfit_of({1, 2, 7, 7, 0.01, -0.04}, two_parts()), 0);
}

TEST(SampleFit, CountsEachPartOverItsLargestValueAndPartsAlike) {
    // The stress ratio is off by 0.2 of 2 everywhere: 0.1. The volumetric strain by 0.02 of 0.04 everywhere: 0.5.
    EXPECT_NEAR(misfit_of({1.2, 1.8, 7, 7, 0.03, -0.02}, two_parts()), std::sqrt((0.01 + 0.25) / 2), 1e-12);
}

} // namespace
} // namespace suffuse::job
