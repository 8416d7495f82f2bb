#pragma once
// Sums of all before, as a counting sort asks for them.

#include "suffuse/base/parallel.hpp"

#include <numeric>
#include <span>
#include <vector>

namespace suffuse {

/// Replaces each value by the sum of those before it. @return the sum of all
template <class Integer>
Integer sum_before(std::span<Integer> values) {
    constexpr std::size_t block = 16'384;
    std::vector<Integer> before((values.size() + block - 1) / block + 1, 0);
    parallel_for(values.size(), block, [&](std::size_t begin, std::size_t end) {
        const auto part = values.subspan(begin, end - begin);
        before[begin / block + 1] = std::accumulate(part.begin(), part.end(), Integer{0});
    });
    std::partial_sum(before.begin(), before.end(), before.begin());
    parallel_for(values.size(), block, [&](std::size_t begin, std::size_t end) {
        const auto part = values.subspan(begin, end - begin);
        std::exclusive_scan(part.begin(), part.end(), part.begin(), before[begin / block]);
    });
    return before.back();
}

} // namespace suffuse
