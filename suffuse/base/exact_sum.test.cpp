#include "suffuse/base/exact_sum.hpp"

#include "suffuse/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace suffuse {
namespace {

double sum_of(const std::vector<double>& terms, double bound) {
    const SumQuanta quanta(bound);
    double coarse = 0, fine = 0;
    for (const double term : terms) {
        add_exactly(quanta, term, coarse, fine);
    }
    return coarse + fine;
}

TEST(ExactSum, HasTheSameBitsInAnyOrderAndWithZerosBetween) {
    RandomStream random(7, "exact sum", 0);
    std::vector<double> terms;
    for (int k = 0; k < 5000; ++k) {
        terms.push_back(1e-7 * random.normal());
    }
    const double forward = sum_of(terms, 20);
    std::reverse(terms.begin(), terms.end());
    EXPECT_EQ(sum_of(terms, 20), forward);
    for (std::size_t k = 0; k < 3000; ++k) {
        terms.insert(terms.begin() + static_cast<std::ptrdiff_t>(2 * k), 0.0);
    }
    EXPECT_EQ(sum_of(terms, 20), forward);
}

TEST(ExactSum, IsAsNearToTheTrueSumAsItsQuantum) {
    // Terms six orders below the bound, as contact forces below the modulus: the finer quantum still resolves them.
    std::vector<double> terms;
    long double wanted = 0;
    RandomStream random(8, "exact sum", 0);
    for (int k = 0; k < 5000; ++k) {
        terms.push_back(1e-6 * random.normal());
        wanted += static_cast<long double>(terms.back());
    }
    EXPECT_NEAR(sum_of(terms, 1), static_cast<double>(wanted), 5000 * 0x1p-82);
}

} // namespace
} // namespace suffuse
