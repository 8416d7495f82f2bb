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
    const Soil soil = surrogate_of(gap_graded, {.finer_than = 0.5e-3});
    EXPECT_NEAR(soil.fines_content, 0.2, 1e-12);
    EXPECT_NEAR(size_at(*soil.coarse, 0.5), 2e-3, 1e-15) << "coarse grains keep their size";
    EXPECT_NEAR(size_at(*soil.fines, 0.5), 0.2e-3, 1e-16);
    EXPECT_NEAR(soil.surrogate->ratio_of_soil, 10, 1e-12);
    EXPECT_NEAR(soil.surrogate->size_ratio, 10, 1e-12);
}

/// Largest size over smallest.
double width_of(const Grading& part) {
    return part.diameter.back() / part.diameter.front();
}

TEST(Surrogate, ItsFractionsAreAsWideAsTheSoilsPartsUpToWhatCanBePaidFor) {
    const Soil capped = surrogate_of(gap_graded, {.finer_than = 0.5e-3}); // both parts are a factor of 4 wide
    EXPECT_NEAR(width_of(*capped.coarse), 2, 1e-12);
    EXPECT_NEAR(width_of(*capped.fines), 4, 1e-12);
    EXPECT_NEAR(*width_between(*capped.fines, 0, 1), *width_between(gap_graded, 0, 0.2), 1e-12);
    const Grading narrow{{0.2e-3, 0.3e-3, 2e-3, 2.02e-3}, {0, 0.2, 0.2, 1}, ""};
    const Soil kept = surrogate_of(narrow, {.finer_than = 0.5e-3});
    EXPECT_NEAR(width_of(*kept.coarse), 1.1 / 0.9, 1e-12) << "at least within a tenth of the mean";
    EXPECT_NEAR(width_of(*kept.fines), 1.5, 1e-12);
    Grading open = gap_graded;
    open.passing.front() = 0.05;
    EXPECT_NEAR(width_of(*surrogate_of(open, {.finer_than = 0.5e-3}).fines), 4, 1e-12) << "unknown: the widest";
    const Soil given = surrogate_of(gap_graded, {.finer_than = 0.5e-3, .coarse_width = 1.5, .fines_width = 3});
    EXPECT_NEAR(width_of(*given.coarse), 1.5, 1e-12);
    EXPECT_NEAR(width_of(*given.fines), 3, 1e-12);
}

TEST(Surrogate, ItsFractionsDoNotOverlapAtAnyRatio) {
    for (const double ratio : {1.3, 1.7, 2.5, 3.0, 10.0}) {
        const Soil soil = surrogate_of(gap_graded, {.finer_than = 0.5e-3, .size_ratio = ratio});
        EXPECT_LE(soil.fines->diameter.back(), soil.coarse->diameter.front() * (1 + 1e-12)) << ratio;
        EXPECT_GE(width_of(*soil.fines), least_width) << ratio;
    }
}

TEST(Surrogate, AnotherRatioMovesTheFinesOnly) {
    const Soil soil = surrogate_of(gap_graded, {.finer_than = 0.5e-3, .size_ratio = 4});
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
    const Grading half{{0.1e-3, 1e-3, 4e-3}, {0.1, 0.3, 1}, "half"};
    const double split = size_at(half, 0.2);
    EXPECT_NEAR(*size_ratio(half, (1 - 1e-5) * split), *size_ratio(half, split), 1e-3) << "rounded in a case";
    EXPECT_FALSE(size_ratio(gap_graded, 5e-3)) << "no coarse grains";
    EXPECT_THROW(surrogate_of(open, {.finer_than = 0.1e-3}), CaseError);
    EXPECT_THROW(surrogate_of(gap_graded, {.finer_than = 0.5e-3, .size_ratio = 1.2}), CaseError)
        << "its fractions overlap";
}

} // namespace
} // namespace suffuse::grains
