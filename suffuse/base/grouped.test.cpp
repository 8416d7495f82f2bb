#include "suffuse/base/grouped.hpp"

#include <gtest/gtest.h>

namespace suffuse {
namespace {

TEST(Grouped, SetsThousandsApart) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(-1234567), "-1,234,567");
    EXPECT_EQ(grouped(-100), "-100");
}

} // namespace
} // namespace suffuse
