#include "suffuse/atlas/table.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

namespace suffuse::atlas {
namespace {

TEST(AtlasTable, ColumnsMayComeInAnyOrderAndLinesMayBeEmpty) {
    const std::vector<Cells> rows = parse_table("b,a\n2,x\n\n4,nan\n");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].text("a"), "x");
    EXPECT_EQ(rows[0].number("b"), 2);
    EXPECT_FALSE(rows[1].optional("a"));
    EXPECT_EQ(rows[1].line(), 4U);
}

TEST(AtlasTable, AMissingColumnIsNamed) {
    const std::vector<Cells> rows = parse_table("a\n1\n");
    EXPECT_THROW((void)rows[0].text("b"), CaseError);
}

} // namespace
} // namespace suffuse::atlas
