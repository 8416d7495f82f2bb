#include "suffuse/atlas/row.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace suffuse::atlas {
namespace {

const std::string header = "ratio,fines,seed,density,flow,grains,porosity,alpha,i_c,i1,i1_at_most,i10,i10_at_most,i50,"
                           "i50_at_most,drag_share,load_bearing,sifting\n";

TEST(AtlasRows, AreReadWithTheirMarksAndWhatWasNotReached) {
    const std::vector<Row> rows =
        parse_rows(header + "4,0.1,2,dense,level,1500,0.4,0.2,nan,0.05,0,0.2,1,nan,0,0.3,0.1,0.02\n");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].density, Density::Dense);
    EXPECT_EQ(rows[0].flow, Flow::Level);
    EXPECT_EQ(rows[0].seed, 2);
    EXPECT_FALSE(rows[0].heave);
    EXPECT_DOUBLE_EQ(heave_gradient(rows[0]), 1.65 * 0.6);
    EXPECT_EQ(rows[0].moves_1.gradient, 0.05);
    EXPECT_FALSE(rows[0].moves_1.is_at_most);
    EXPECT_TRUE(rows[0].moves_10.is_at_most);
    EXPECT_FALSE(rows[0].moves_50.gradient);
}

TEST(AtlasRows, ABrokenLineIsNamed) {
    for (const char* const line :
         {"4,0.1\n", "4,0.1,2,firm,level,1500,0.4,0.2,nan,0.05,0,0.2,1,nan,0,0.3,0.1,0.02\n",
          "4,0.1,2,dense,level,1500,much,0.2,nan,0.05,0,0.2,1,nan,0,0.3,0.1,0.02\n",
          "4,0.1,2,dense,level,1500,nan,0.2,nan,0.05,0,0.2,1,nan,0,0.3,0.1,0.02\n"}) {
        try {
            parse_rows(header + line);
            ADD_FAILURE() << line;
        } catch (const CaseError& error) {
            EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(parse_rows("ratio,fines\n4,0.1\n"), CaseError);
}

TEST(AtlasRows, ThoseThatAreShippedAreConsistent) {
    std::set<std::tuple<double, double, int, Density, Flow>> keys;
    ASSERT_FALSE(shipped_rows().empty());
    for (const Row& row : shipped_rows()) {
        EXPECT_TRUE(keys.emplace(row.size_ratio, row.fines_content, row.seed, row.density, row.flow).second);
        EXPECT_GT(row.size_ratio, 1);
        EXPECT_TRUE(row.fines_content > 0 && row.fines_content < 0.5) << row.fines_content;
        EXPECT_TRUE(row.porosity > 0.2 && row.porosity < 0.65) << row.porosity;
        EXPECT_GT(row.alpha, 0);
        EXPECT_EQ(row.heave.has_value(), row.flow == Flow::Up) << "level flow lifts nothing";
        // rounding to six digits
        EXPECT_NEAR(heave_gradient(row), 1.65 * (1 - row.porosity), 1e-5);
        if (row.moves_1.gradient && row.moves_10.gradient) {
            EXPECT_LE(*row.moves_1.gradient, *row.moves_10.gradient);
        }
        EXPECT_TRUE(row.sifting >= 0 && row.sifting <= 1) << row.sifting;
    }
}

} // namespace
} // namespace suffuse::atlas
