#include "suffuse/answer/triaxial_table.hpp"

#include "suffuse/study/trace_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace suffuse::answer {
namespace {

using triaxial::Path;
using triaxial::TriaxialSpec;

/// The table of one test, made on as many samples as there are responses.
figures::PageTable table_of(const TriaxialSpec& test, const std::vector<nlohmann::json>& responses) {
    casefile::Case what;
    casefile::Study& study = what.studies.emplace_back();
    study.name = "s";
    study.stages = {{.name = "shear", .spec = test}};
    study.variants.resize(responses.size());
    study::RunResults results;
    results.what = &what;
    for (std::size_t k = 0; k < responses.size(); ++k) {
        results.stages.push_back(
            {&study,
             &study.variants[k],
             study.stages.data(),
             {{"response", responses[k]}, {"deviator_stress", 100e3}},
             {}}
        );
    }
    results.curves = study::trace_curves(what, results.stages);
    return tabulate_tests(results).value();
}

nlohmann::json response() {
    return {{"peak_deviator", 300e3},          {"peak_strain", 0.02}, {"friction_angle", 0.6},
            {"final_deviator", 200e3},         {"stiffness", 50e6},   {"dilatancy", 0.3},
            {"final_volumetric_strain", -0.01}};
}

bool has_column(const figures::PageTable& table, const std::string& name) {
    return std::ranges::any_of(table.header, [&](const std::string& h) { return h.starts_with(name); });
}

TEST(TriaxialTable, OfDrainedTestsHasNoColumnsOfPorePressure) {
    nlohmann::json drained = response();
    drained["instability"] = {{"q", 45e3}};
    const figures::PageTable table = table_of({.strain = 0.1}, {drained});
    EXPECT_EQ(
        table.rows.front(), (std::vector<std::string>{"s, shear", "1", "300", "2", "34.4", "200", "50", "0.3", "−1"})
    );
    EXPECT_FALSE(
        has_column(table, "excess pore pressure") || has_column(table, "liquefied") || has_column(table, "unstable")
    );
    EXPECT_EQ(table.note.find("iquefied"), std::string::npos);
    EXPECT_EQ(table.header.size(), table.numeric.size());
}

TEST(TriaxialTable, CountsLiquefiedSamplesAndReportsInstabilityAndPorePressure) {
    nlohmann::json flows = response(), stays = response();
    flows.update({{"liquefied", true}, {"excess_pore_pressure", 90e3}, {"instability", {{"q", 60e3}}}});
    stays.update({{"liquefied", false}, {"excess_pore_pressure", 70e3}, {"instability", nullptr}});
    const figures::PageTable table = table_of({.path = Path::Undrained, .strain = 0.1}, {flows, stays, stays});
    EXPECT_EQ(table.rows.front().back(), "1 of 3");
    EXPECT_EQ(table.rows.front()[table.rows.front().size() - 2], "77 ± 12");
    EXPECT_EQ(table.rows.front()[table.rows.front().size() - 3], "60");
    EXPECT_FALSE(has_column(table, "dilatancy") || has_column(table, "εᵥ")) << "at constant volume there is none";
}

TEST(TriaxialTable, SaysNothingThatATestDoesNotShow) {
    EXPECT_FALSE(has_column(table_of({.strain = 0.019}, {response()}), "dilatancy")) << "over one percent of strain";
    EXPECT_TRUE(has_column(table_of({.strain = 0.021}, {response()}), "dilatancy"));
    const figures::PageTable stops = table_of({.stress_ratio = 0.75}, {response()});
    EXPECT_FALSE(has_column(stops, "highest q") || has_column(stops, "friction") || has_column(stops, "E50"));
    EXPECT_TRUE(has_column(stops, "q at the end"));
    EXPECT_EQ(stops.rows.front()[2], "100") << "of the state at rest, not of the test that went beyond it";
}

} // namespace
} // namespace suffuse::answer
