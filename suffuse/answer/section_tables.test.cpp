#include "suffuse/answer/section_tables.hpp"

#include <gtest/gtest.h>

namespace suffuse::answer {
namespace {

TEST(KozenyCarman, OfEqualSpheresIsTheClosedForm) {
    const double d = 1e-3, n = 0.4;
    EXPECT_NEAR(kozeny_carman({d / 2, d / 2, d / 2}, n), n * n * n * d * d / (180 * 0.6 * 0.6), 1e-22); // rounding
}

TEST(KozenyCarman, TheSauterDiameterIsThatOfEqualSurfacePerVolume) {
    // Of spheres of 1 mm and 3 mm: (1 + 27)/(1 + 9) mm.
    EXPECT_NEAR(kozeny_carman({0.5e-3, 1.5e-3}, 0.4), kozeny_carman({1.4e-3}, 0.4), 1e-20); // rounding
}

TEST(WaterTable, ReportsAPermeabilityAlsoAsAConductivityOfTheFluid) {
    casefile::Study study;
    casefile::Variant variant;
    casefile::Stage seep{.name = "seep", .spec = flow::FlowSpec{}};
    const nlohmann::json numbers = {{"permeability", 1e-10}, {"porosity", 0.4}, {"tortuosity", 1.234}};
    const nlohmann::json still = {{"permeability", 1e-10}, {"porosity", 0.4}, {"tortuosity", nullptr}};
    const auto table = tabulate_water(
        "nowhere", {{&study, &variant, &seep, numbers, {}}, {&study, &variant, &seep, still, {}}}, {}, {1000, 1e-3}
    );
    ASSERT_TRUE(table.has_value());
    EXPECT_EQ(table->header[3], "conductivity K [m/s]");
    EXPECT_EQ(table->rows[0][3], "9.81·10⁻⁴");
    EXPECT_EQ(table->rows[0].back(), "1.23");
    EXPECT_EQ(table->rows[1].back(), "–") << "at a gradient of 0 it is unknown";
    EXPECT_EQ(table->rows[0].size(), table->header.size());
}

TEST(RemovalTable, HasARowForEachPassAndNoneForWhatTakesAllAtOnce) {
    casefile::Study study;
    study.name = "s";
    study.replicates = 3;
    study.sweep = {{"stage.removed.order", {"random"}}};
    casefile::Variant variant;
    variant.values = {{"stage.removed.order", std::string("random")}};
    variant.replicate = 2;
    casefile::Stage in_part{.name = "removed", .spec = erosion::RemoveSpec{.share = 0.5, .passes = 2}};
    casefile::Stage at_once{.name = "emptied", .spec = erosion::RemoveSpec{}};
    const auto pass = [](int number, double mass) {
        return nlohmann::json{
            {"pass", number},
            {"eroded_mass_percent_of_initial", mass},
            {"coordination_histogram", {{"0", 3}, {"4", 1}}},
            {"stress_loss", 0.02},
            {"volumetric_strain", 0.001},
            {"porosity_after", 0.4}};
    };
    const nlohmann::json numbers = {
        {"passes", {pass(1, 5), pass(2, 7)}}, {"coordination_histogram", {{"0", 6}}}, {"volumetric_strain", 0.002}};
    const figures::PageTable table =
        *tabulate_removals({{&study, &variant, &in_part, numbers, {}}, {&study, &variant, &at_once, numbers, {}}});
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(
        table.rows[1], (std::vector<std::string>{
                           "s, removed, order random, sample 2", "2", "4", "12.00", "1.00", "2.00", "0.10", "0.4000"})
    );
    EXPECT_EQ(table.header.size(), table.rows[0].size());
    EXPECT_FALSE(tabulate_removals({{&study, &variant, &at_once, numbers, {}}}).has_value());
}

} // namespace
} // namespace suffuse::answer
