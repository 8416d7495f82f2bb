#include "suffuse/report/html.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::report {
namespace {

TEST(Html, WhatStandsInBackticksIsCodeAndStaysEscaped) {
    EXPECT_EQ(typeset("take `a<b>` or `order`"), "take <code>a&lt;b&gt;</code> or <code>order</code>");
    EXPECT_EQ(typeset("one ` alone"), "one ` alone");
    EXPECT_NE(html_table({"a"}, {{"take `b`"}}, {}, "c").find("<td>take <code>b</code></td>"), std::string::npos);
}

TEST(Html, IndicesOfOurSymbolsAreSetLowAndNamesOfTheUserStay) {
    EXPECT_EQ(
        with_indices("FC_active, e_min = 0.4, i_c and (e_g)"),
        "FC<sub>active</sub>, e<sub>min</sub> = 0.4, i<sub>c</sub> and (e<sub>g</sub>)"
    );
    const std::string names = "fines_content, some_name_min, e_mine, FC_active_2";
    EXPECT_EQ(with_indices(names), names);
    EXPECT_EQ(html_table({"e_eq"}, {{"<b>e_min"}}, {}, "c").find("<b>"), std::string::npos);
    EXPECT_NE(html_table({"e_eq"}, {{"<b>e_min"}}, {}, "c").find("&lt;b&gt;e<sub>min</sub>"), std::string::npos);
}

TEST(Html, NumbersAreWrittenAsPeopleDo) {
    EXPECT_EQ(in_figures(1.11022e-14, 6), "1.11022\u00a0×\u00a010⁻¹⁴");
    EXPECT_EQ(in_figures(-0.25, 6), "−0.25");
    EXPECT_EQ(in_figures(-0.0, 6), "0");
    EXPECT_EQ(in_figures(123456, 3), "123456") << "a count, to the last";
    EXPECT_EQ(in_figures(std::nan(""), 6), "");
    EXPECT_EQ(typeset("error 1.5e-16 of 2·10⁵"), "error 1.5\u00a0×\u00a010⁻¹⁶ of 2\u00a0×\u00a010⁵");
    EXPECT_EQ(typeset("commit 471e85, run-2e5"), "commit 471e85, run-2e5") << "names stay as they are";
}

TEST(Html, ATableOfManyColumnsOrRowsIsMarkedForPaper) {
    const std::vector<std::string> many(9, "x");
    EXPECT_NE(html_table(many, {many}, {}, "t").find("class=\"scroll broad\""), std::string::npos);
    EXPECT_NE(
        html_table({"a"}, std::vector<std::vector<std::string>>(26, {"1"}), {}, "t").find("scroll long"),
        std::string::npos
    );
    EXPECT_NE(html_table({"a"}, {{"1"}}, {}, "t", "<b>T</b>").find("<caption><b>T</b></caption>"), std::string::npos);
}

TEST(Html, ALongTextOfATableIsGivenRoom) {
    const std::string table = html_table({"a", "b"}, {{"short", "1"}, {std::string(50, 'x'), "2"}}, {false, true}, "t");
    EXPECT_NE(table.find("<td>short</td>"), std::string::npos);
    EXPECT_NE(table.find("<td class=\"long\">xxx"), std::string::npos);
    EXPECT_NE(table.find("<td class=\"number\">2</td>"), std::string::npos);
}

} // namespace
} // namespace suffuse::report
