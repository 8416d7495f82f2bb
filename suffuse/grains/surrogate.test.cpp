#include "suffuse/grains/surrogate.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::grains {
namespace {

/// A fifth of it from 0.1 to 0.4 mm, the rest from 1 to 4 mm: medians of 0.2 and 2 mm.
const Grading gap_graded{{0.1e-3, 0.4e-3, 1e-3, 4e-3}, {0, 0.2, 0.2, 1}, "gap"};

TEST(Surrogate, HasTheSizeRatioOfTheMediansAndTheFinesContentOfTheCurve) {
    EXPECT_NEAR(*size_ratio(gap_graded, 0.5e-3), 10, 1e-12);
    const Soil soil = surrogate_of(gap_graded, 0.5e-3);
    EXPECT_NEAR(soil.fines_content, 0.2, 1e-12);
    EXPECT_NEAR(size_at(*soil.coarse, 0.5), 2e-3, 1e-15) << "coarse grains keep their size";
    EXPECT_NEAR(size_at(*soil.fines, 0.5), 0.2e-3, 1e-16);
    EXPECT_NEAR(soil.surrogate->ratio_of_soil, 10, 1e-12);
    EXPECT_NEAR(soil.surrogate->size_ratio, 10, 1e-12);
}

TEST(Surrogate, ItsFractionsAreWithinATenthOfTheirMeanSize) {
    const Soil soil = surrogate_of(gap_graded, 0.5e-3);
    for (const Grading& part : {*soil.coarse, *soil.fines}) {
        const double mean = (part.diameter.front() + part.diameter.back()) / 2;
        EXPECT_NEAR(part.diameter.front(), 0.9 * mean, 1e-12 * mean);
        EXPECT_NEAR(part.diameter.back(), 1.1 * mean, 1e-12 * mean);
    }
}

TEST(Surrogate, AnotherRatioMovesTheFinesOnly) {
    const Soil soil = surrogate_of(gap_graded, 0.5e-3, 4);
    EXPECT_NEAR(size_at(*soil.coarse, 0.5), 2e-3, 1e-15);
    EXPECT_NEAR(size_at(*soil.fines, 0.5), 0.5e-3, 1e-16);
    EXPECT_NEAR(soil.surrogate->ratio_of_soil, 10, 1e-12);
    EXPECT_EQ(soil.surrogate->size_ratio, 4);
}

TEST(Surrogate, DependsOnNoLength) {
    Grading larger = gap_graded;
    for (double& d : larger.diameter) {
        d *= 37;
    }
    EXPECT_NEAR(*size_ratio(larger, 37 * 0.5e-3), *size_ratio(gap_graded, 0.5e-3), 1e-12);
}

TEST(Surrogate, NeedsTheMiddleOfBothPartsOnTheMeasuredCurve) {
    const Grading open{{0.1e-3, 0.4e-3, 1e-3, 4e-3}, {0.08, 0.2, 0.2, 0.7}, "open"};
    EXPECT_TRUE(size_ratio(open, 0.5e-3)) << "10 % and 60 % were measured";
    EXPECT_FALSE(size_ratio(open, 0.1e-3)) << "4 % was not";
    EXPECT_FALSE(size_ratio(gap_graded, 5e-3)) << "no coarse grains";
    EXPECT_THROW(surrogate_of(open, 0.1e-3), CaseError);
    EXPECT_THROW(surrogate_of(gap_graded, 0.5e-3, 1.2), CaseError) << "its fractions overlap";
}

} // namespace
} // namespace suffuse::grains
