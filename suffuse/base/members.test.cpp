#include "suffuse/base/members.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse {
namespace {

TEST(Members, StandInTheirGroupsInRisingOrder) {
    const std::vector<std::uint32_t> group = {2, 0, 2, 3, 0, 2};
    const Members members = members_of(group.size(), 5, [&](std::size_t i) { return group[i]; });
    EXPECT_EQ(members.first, (std::vector<std::uint32_t>{0, 2, 2, 5, 6, 6}));
    EXPECT_EQ(members.row, (std::vector<std::uint32_t>{1, 4, 0, 2, 5, 3}));
    EXPECT_TRUE(std::ranges::equal(members.of(2), std::vector<std::uint32_t>{0, 2, 5}));
    EXPECT_TRUE(members.of(4).empty());
}

TEST(Members, OfNothingAreNone) {
    const Members members = members_of(0, 0, [](std::size_t) { return 0U; });
    EXPECT_EQ(members.first, (std::vector<std::uint32_t>{0}));
    EXPECT_TRUE(members.row.empty());
}

} // namespace
} // namespace suffuse
