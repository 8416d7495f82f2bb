#include "suffuse/base/prefix_sum.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace suffuse {
namespace {

TEST(PrefixSum, IsTheSumOfAllBeforeForAnyNumberOfThreadsAndBlocks) {
    for (const int threads : {1, 3}) {
        set_thread_count(threads);
        for (const std::size_t rows : {0, 1, 5, 16'384, 16'385, 100'000}) {
            std::vector<std::uint32_t> values(rows), expected(rows);
            std::uint32_t sum = 0;
            for (std::size_t k = 0; k < rows; ++k) {
                values[k] = static_cast<std::uint32_t>(k * 7 % 11);
                expected[k] = sum;
                sum += values[k];
            }
            EXPECT_EQ(sum_before(std::span(values)), sum);
            EXPECT_EQ(values, expected);
        }
    }
    set_thread_count(1);
}

} // namespace
} // namespace suffuse
