#include "suffuse/report/html.hpp"

#include <gtest/gtest.h>

namespace suffuse::report {
namespace {

TEST(Html, WhatStandsInBackticksIsCodeAndStaysEscaped) {
    EXPECT_EQ(typeset("take `a<b>` or `order`"), "take <code>a&lt;b&gt;</code> or <code>order</code>");
    EXPECT_EQ(typeset("one ` alone"), "one ` alone");
}

TEST(Html, IndicesOfOurSymbolsAreSetLowAndNamesOfTheUserStay) {
    EXPECT_EQ(
        with_indices("FC_active, e_min = 0.4 and (e_g)"),
        "FC<sub>active</sub>, e<sub>min</sub> = 0.4 and (e<sub>g</sub>)"
    );
    const std::string names = "fines_content, some_name_min, e_mine, FC_active_2";
    EXPECT_EQ(with_indices(names), names);
    EXPECT_EQ(html_table({"e_eq"}, {{"<b>e_min"}}, {}, "c").find("<b>"), std::string::npos);
    EXPECT_NE(html_table({"e_eq"}, {{"<b>e_min"}}, {}, "c").find("&lt;b&gt;e<sub>min</sub>"), std::string::npos);
}

TEST(Html, ALongTextOfATableIsGivenRoom) {
    const std::string table = html_table({"a", "b"}, {{"short", "1"}, {std::string(50, 'x'), "2"}}, {false, true}, "t");
    EXPECT_NE(table.find("<td>short</td>"), std::string::npos);
    EXPECT_NE(table.find("<td class=\"long\">xxx"), std::string::npos);
    EXPECT_NE(table.find("<td class=\"number\">2</td>"), std::string::npos);
}

} // namespace
} // namespace suffuse::report
