#include "suffuse/grains/gradation.hpp"

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

} // namespace
} // namespace suffuse::grains
