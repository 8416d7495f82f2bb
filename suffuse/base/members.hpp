#pragma once
// Rows sorted into groups by counting them.

#include <cstddef>
#include <cstdint>
#include <numeric>
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
    Members members{std::vector<std::uint32_t>(groups + 2, 0), std::vector<std::uint32_t>(rows)};
    for (std::size_t i = 0; i < rows; ++i) {
        ++members.first[group_of(i) + 2];
    }
    std::partial_sum(members.first.begin(), members.first.end(), members.first.begin());
    for (std::size_t i = 0; i < rows; ++i) { // afterwards every group begins where the one before it ends
        members.row[members.first[group_of(i) + 1]++] = static_cast<std::uint32_t>(i);
    }
    members.first.pop_back();
    return members;
}

} // namespace suffuse
