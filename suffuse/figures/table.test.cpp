#include "suffuse/figures/table.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/escaped.hpp"
#include "suffuse/figures/figure.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>

namespace suffuse::figures {
namespace {

TEST(Table, CsvHasRemarksThenNamesWithUnitsThenRows) {
    Table table;
    table.add("pass", {"pass 1", "pass 2"});
    table.add("eroded_mass", "%", {13.5, std::nan("")});
    EXPECT_EQ(
        to_csv(table, {{"run", "r1"}, {"title", "two\nlines"}}),
        "# run: r1\n# title: two lines\npass,eroded_mass [%]\npass 1,13.5\npass 2,\n"
    );
}

TEST(Table, NumbersReadBackToTheSameBits) {
    Table table;
    const std::vector<double> values = {0.1, 1.0 / 3.0, 6.02214076e23, 5e-324, -0.0};
    table.add("x", "", values);
    for (std::size_t row = 0; row < values.size(); ++row) {
        EXPECT_EQ(std::strtod(table.cell(row, 0).c_str(), nullptr), values[row]);
    }
    EXPECT_EQ(table.cell(1, 0, 3), "0.333");
}

TEST(Table, WordsWithCommasAndQuotesAreQuoted) {
    Table table;
    table.add("name", {"a,b", "say \"so\""});
    EXPECT_EQ(to_csv(table, {}), "name\n\"a,b\"\n\"say \"\"so\"\"\"\n");
}

TEST(Table, ColumnsOfDifferentLengthAreADefect) {
    Table table;
    table.add("x", "m", {1.0, 2.0});
    EXPECT_THROW(table.add("y", "m", {1.0}), Bug);
    EXPECT_THROW((void)table.numbers("z"), Bug);
}

TEST(Figure, MissingNumbersBecomeNullInItsSpecification) {
    Figure figure;
    figure.table.add("x", "m", {1.5, std::nan("")});
    figure.table.add("name", {"a", "b"});
    figure.chart = {{"mark", "point"}};
    const nlohmann::json rows = complete_specification(figure)["data"]["values"];
    EXPECT_EQ(rows, nlohmann::json::parse(R"([{"x": 1.5, "name": "a"}, {"x": null, "name": "b"}])"));
}

TEST(Html, NothingOfATextEndsItsElementOrAttribute) {
    EXPECT_EQ(escaped("</script><img onerror=\"x\">&'"), "&lt;/script&gt;&lt;img onerror=&quot;x&quot;&gt;&amp;&#39;");
}

TEST(Table, AFactBringsItsUnitAndNamesItsAxis) {
    Figure figure;
    figure.table.add_fact("mean_stress", {100e3, 99.8e3});
    figure.table.add_fact("void_ratio", {0.7, 0.71});
    EXPECT_EQ(heading(figure.table.columns().front()), "mean_stress [kPa]");
    EXPECT_EQ(figure.table.numbers("mean_stress").back(), 99.8);
    figure.chart = nlohmann::json::parse(R"({"layer": [{"encoding": {
        "x": {"field": "mean_stress"}, "y": {"field": "void_ratio", "title": "e of a test"},
        "order": {"field": "mean_stress"}, "tooltip": [{"field": "mean_stress"}, {"field": "sample"}]}}]})");
    const nlohmann::json encoding = complete_specification(figure)["layer"][0]["encoding"];
    EXPECT_EQ(encoding["x"]["title"], "mean stress p [kPa]");
    EXPECT_EQ(encoding["y"]["title"], "e of a test");
    EXPECT_FALSE(encoding["order"].contains("title"));
    EXPECT_EQ(
        encoding["tooltip"][0],
        nlohmann::json::parse(R"({"field": "mean_stress", "title": "p [kPa]", "format": ".4g"})")
    );
    EXPECT_FALSE(encoding["tooltip"][1].contains("title"));
}

} // namespace
} // namespace suffuse::figures
