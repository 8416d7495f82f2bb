#pragma once
// Rows sorted into groups by counting them.

#include "suffuse/base/parallel.hpp"
#include "suffuse/base/prefix_sum.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace suffuse {

/// The rows of each group, group after group, in rising order within each.
struct Members {
    std::vector<std::uint32_t> first; ///< those of group g are row[first[g]], ... row[first[g + 1] - 1]
    std::vector<std::uint32_t> row;

    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t group) const {
        return {row.data() + first[group], first[group + 1] - first[group]};
    }
};

/// Sorts `rows` rows into `groups` groups; row i belongs to `group_of(i)`.
template <class GroupOf>
Members members_of(std::size_t rows, std::size_t groups, GroupOf&& group_of) {
    constexpr std::size_t block = 8192;
    Members members{std::vector<std::uint32_t>(groups + 1, 0), std::vector<std::uint32_t>(rows)};
    const auto take_one = [](std::uint32_t& count) {
        return std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed);
    };
    parallel_for(rows, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            take_one(members.first[group_of(i)]);
        }
    });
    sum_before(std::span(members.first));
    std::vector<std::uint32_t> next = members.first;
    parallel_for(rows, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            members.row[take_one(next[group_of(i)])] = static_cast<std::uint32_t>(i);
        }
    });
    parallel_for(groups, block, [&](std::size_t begin, std::size_t end) { // threads came as they liked
        for (std::size_t g = begin; g < end; ++g) {
            const auto first = members.row.begin() + members.first[g],
                       last = members.row.begin() + members.first[g + 1];
            if (!std::is_sorted(first, last)) {
                std::sort(first, last);
            }
        }
    });
    return members;
}

} // namespace suffuse
