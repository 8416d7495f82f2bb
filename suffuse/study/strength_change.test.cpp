#include "suffuse/study/strength_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace suffuse::study {
namespace {

std::optional<bool> is_weaker(triaxial::Path path, const std::vector<double>& change) {
    const casefile::Stage test{.name = "shear", .spec = triaxial::TriaxialSpec{.path = path}};
    StrengthChange found;
    found.after = &test;
    (found.holds_deviator() ? found.pore_pressure : found.peak_deviator).change = scatter_of(change);
    return found.is_weaker();
}

TEST(StrengthChange, OfOneSampleIsClearBeyondWhatOthersDifferBy) {
    using triaxial::Path;
    EXPECT_EQ(is_weaker(Path::Drained, {-0.099}), std::nullopt);
    EXPECT_EQ(is_weaker(Path::Drained, {-0.101}), true);
    EXPECT_EQ(is_weaker(Path::Drained, {0.101}), false);
    EXPECT_EQ(is_weaker(Path::ConstantDeviator, {-0.499}), std::nullopt);
    EXPECT_EQ(is_weaker(Path::ConstantDeviator, {-0.501}), true);
}

TEST(StrengthChange, OfSeveralSamplesIsClearBeyondTheirDeviation) {
    const double apart = 0.05 * std::sqrt(0.5); // of two that deviate by 5 %
    EXPECT_EQ(is_weaker(triaxial::Path::Drained, {-0.049 - apart, -0.049 + apart}), std::nullopt);
    EXPECT_EQ(is_weaker(triaxial::Path::Drained, {-0.051 - apart, -0.051 + apart}), true);
}

} // namespace
} // namespace suffuse::study
