#include "suffuse/study/factor_of_safety.hpp"

#include <gtest/gtest.h>

namespace suffuse::study {
namespace {

TEST(FactorsOfSafety, OfSeveralSamplesHasItsDeviationToTheSameDigit) {
    EXPECT_EQ(factor_text(scatter_of({0.9, 0.98})), "0.94 ± 0.06");
    EXPECT_EQ(factor_text(scatter_of({1.5, 1.501})), "1.5");
    EXPECT_EQ(factor_text(scatter_of({})), "–");
}

} // namespace
} // namespace suffuse::study
