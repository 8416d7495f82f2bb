#include "suffuse/base/exact_sum.hpp"

#include "suffuse/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace suffuse {
namespace {

double sum_of(const std::vector<double>& terms, double largest_term, double largest_sum) {
    const SumQuantum quantum(largest_term, largest_sum);
    std::uint64_t sum = 0;
    for (const double term : terms) {
        sum += quantum.count(term);
    }
    return quantum.value(sum);
}

TEST(ExactSum, HasTheSameBitsInAnyOrderAndWithZerosBetween) {
    RandomStream random(7, "exact sum", 0);
    std::vector<double> terms;
    for (int k = 0; k < 5000; ++k) {
        terms.push_back(1e-7 * random.normal());
    }
    const double forward = sum_of(terms, 1e-5, 20);
    std::reverse(terms.begin(), terms.end());
    EXPECT_EQ(sum_of(terms, 1e-5, 20), forward);
    for (std::size_t k = 0; k < 3000; ++k) {
        terms.insert(terms.begin() + static_cast<std::ptrdiff_t>(2 * k), 0.0);
    }
    EXPECT_EQ(sum_of(terms, 1e-5, 20), forward);
}

TEST(ExactSum, IsAsNearToTheTrueSumAsItsQuantum) {
    std::vector<double> terms;
    long double wanted = 0;
    RandomStream random(8, "exact sum", 0);
    for (int k = 0; k < 5000; ++k) {
        terms.push_back(1e-6 * random.normal());
        wanted += static_cast<long double>(terms.back());
    }
    EXPECT_NEAR(
        sum_of(terms, 0x1p-17, 1), static_cast<double>(wanted), 5000 * 0x1p-62
    );                                                                                // few and large: the sum decides
    EXPECT_NEAR(sum_of(terms, 1, 1e-3), static_cast<double>(wanted), 5000 * 0x1p-51); // the largest term does
}

TEST(ExactSum, HoldsTermsAndSumsUpToTheirBounds) {
    const std::vector<double> large(4000, -0.999);
    EXPECT_NEAR(sum_of(large, 1, 4000), -3996, 4000 * 0x1p-49);
}

} // namespace
} // namespace suffuse
