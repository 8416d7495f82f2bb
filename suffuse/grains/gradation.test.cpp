#include "suffuse/grains/gradation.hpp"

#include "suffuse/grains/grading.hpp"

#include <gtest/gtest.h>

namespace suffuse::grains {
namespace {

/// Masses 1, 1, 8 and 64 (diameters 1, 1, 2, 4).
Grains four_grains() {
    Grains grains;
    for (const double radius : {2.0, 0.5, 1.0, 0.5}) {
        add_grain(grains, {}, radius, 2600);
    }
    grains.fine = {0, 1, 0, 1};
    return grains;
}

TEST(Gradation, OfFourGrainsPassesByMass) {
    const Gradation gradation = measure_gradation(four_grains());
    EXPECT_EQ(gradation.diameter, (std::vector<double>{1, 2, 4}));
    EXPECT_NEAR(passing(gradation, 1), 2.0 / 74, 1e-15);
    EXPECT_NEAR(passing(gradation, 3.9), 10.0 / 74, 1e-15);
    EXPECT_EQ(passing(gradation, 4), 1);
    EXPECT_EQ(passing(gradation, 0.9), 0);
}

TEST(Gradation, SizeAtAFractionIsTheSmallestThatPassesIt) {
    const Gradation gradation = measure_gradation(four_grains());
    EXPECT_EQ(size_at(gradation, 0.5), 4);
    EXPECT_EQ(size_at(gradation, 2.0 / 74), 1);
    EXPECT_EQ(size_at(gradation, 2.01 / 74), 2);
    EXPECT_EQ(size_at(gradation, 0), 1);
    EXPECT_EQ(size_at(gradation, 1), 4);
}

TEST(Gradation, OfAFractionLeavesTheOtherOut) {
    const Grains grains = four_grains();
    EXPECT_EQ(measure_gradation_of(grains, true).diameter, std::vector<double>{1});
    EXPECT_EQ(measure_gradation_of(grains, false).diameter, (std::vector<double>{2, 4}));
}

TEST(Gradation, IsThatOfTheSolidWhateverInertiaTheGrainsAreLent) {
    Grains grains = four_grains();
    const Gradation own = measure_gradation(grains);
    grains.mass[1] *= 64, grains.mass[3] *= 64;
    EXPECT_EQ(measure_gradation(grains).passing, own.passing);
    EXPECT_EQ(median_diameter(grains), 4);
}

TEST(Gradation, OfNoGrainsIsEmpty) {
    const Gradation gradation = measure_gradation({});
    EXPECT_EQ(passing(gradation, 1), 0);
    EXPECT_EQ(size_at(gradation, 0.5), 0);
}

TEST(Gradation, OfFewSizesIsACurveOfSteps) {
    const Grading curve = curve_of_steps(measure_gradation(four_grains()));
    EXPECT_NO_THROW(check(curve));
    // The masses are 2 of size 1, 8 of size 2, 64 of size 4. A step is 1e-6 of its size wide.
    EXPECT_NEAR(passing(curve, 1), 2.0 / 74, 1e-15);
    EXPECT_NEAR(passing(curve, 1.99), 2.0 / 74, 1e-15);
    EXPECT_NEAR(passing(curve, 3.99), 10.0 / 74, 1e-15);
    EXPECT_NEAR(size_at(curve, 0.1), 2, 2e-6);
    EXPECT_NEAR(size_at(curve, 0.5), 4, 4e-6);
}

TEST(Gradation, OfSizesThatOnlyRoundingDistinguishesIsOneStep) {
    Grains grains;
    for (const double radius : {1.0, 1 + 2e-16, 1 + 1e-9}) {
        add_grain(grains, {}, radius, 2600);
    }
    const Grading curve = curve_of_steps(measure_gradation(grains));
    EXPECT_NO_THROW(check(curve));
    EXPECT_EQ(curve.diameter.size(), 2U);
    EXPECT_EQ(curve.passing, (std::vector<double>{0, 1}));
}

} // namespace
} // namespace suffuse::grains
