#include "suffuse/answer/removal_table.hpp"

#include <gtest/gtest.h>

namespace suffuse::answer {
namespace {

TEST(RemovalTable, HasTheIsotropicStateFirstAndMeansOverTheSeeds) {
    const std::vector<study::Removal> removals = {
        {0.1, 1, 0.75, 0.1, 0.02, 0.5, true, std::nullopt, std::nullopt},
        {0.3, 1, 0.0, 0.3, 0.04, 0.2, false, 200e3, 100e3},
        {0.1, 1, 0.0, 0.1, 0.01, 0.1, false, 200e3, 180e3},
        {0.1, 2, 0.0, 0.1, 0.03, 0.3, false, 200e3, 220e3}};
    const figures::PageTable table = *removal_table(removals);
    ASSERT_EQ(table.rows.size(), 3U);
    EXPECT_EQ(
        table.rows[0],
        (std::vector<std::string>{"10", "0", "2", "10", "2 ± 1.4", "20 ± 14", "100 ± 14"}) // deviations: sqrt(2)
    );
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"30", "0", "1", "30", "4", "20", "50"}));
    EXPECT_EQ(table.rows[2], (std::vector<std::string>{"10", "0.75", "1", "10", "above 2", "50", "–"}));
    for (const auto& row : table.rows) {
        EXPECT_EQ(row.size(), table.header.size());
    }
    EXPECT_FALSE(removal_table({}).has_value());
}

} // namespace
} // namespace suffuse::answer
