#include "suffuse/figures/figure_options.hpp"

#include "suffuse/figures/figures.hpp"
#include "suffuse/figures/figures_fines.hpp"

#include <gtest/gtest.h>

#include "tests/support/sample_results.hpp"

namespace suffuse::figures {
namespace {

using nlohmann::json;

Figure sample_test() {
    return *triaxial_response({test::sample_response("before erosion", 3.2e5, 0.06)});
}

TEST(FigureOptions, FiguresAreRequestedByKindOrByName) {
    Figure ninth, rules;
    ninth.id = "fig09";
    rules.id = "own-rules";
    EXPECT_TRUE(is_requested({"paper", "own"}, ninth) && is_requested({"paper", "own"}, rules));
    EXPECT_TRUE(is_requested({"paper"}, ninth));
    EXPECT_FALSE(is_requested({"paper"}, rules));
    EXPECT_TRUE(is_requested({"figure-9"}, ninth) && is_requested({"own-rules"}, rules));
    EXPECT_FALSE(is_requested({"figure-10"}, ninth));
    EXPECT_FALSE(is_requested({}, ninth));
}

TEST(FigureOptions, DilationUpTurnsTheAxisOfVolumetricStrainOnly) {
    Figure figure = sample_test();
    const Table before = figure.table;
    draw_dilation_up(figure);
    EXPECT_EQ(figure.chart["vconcat"][1]["encoding"]["y"]["scale"]["reverse"], true);
    EXPECT_FALSE(figure.chart["vconcat"][0]["encoding"]["y"].dump().find("reverse") != std::string::npos);
    EXPECT_EQ(figure.table.numbers("volumetric_strain"), before.numbers("volumetric_strain"));
    Figure path = *stress_path(test::sample_erosion());
    draw_dilation_up(path);
    EXPECT_NE(path.chart.dump().find("\"reverse\":true"), std::string::npos);
}

TEST(FigureOptions, PointsLieOverThePanelsWhoseColumnsTheyHave) {
    Figure figure = sample_test();
    Points points;
    points.add("axial_strain", "%", {1, 2, 3});
    points.add("deviator_stress", "kPa", {100, std::nan(""), 300});
    points.add("series", {"test A", "test A", "test B"});
    EXPECT_TRUE(lay_over(figure, points, "points.csv"));
    const json& layers = figure.chart["vconcat"][0]["layer"];
    ASSERT_EQ(layers.size(), 2U);
    EXPECT_EQ(layers[0]["mark"]["type"], "line");
    const json& values = layers[1]["data"]["values"];
    ASSERT_EQ(values.size(), 2U); // the second point has no stress
    EXPECT_EQ(values[1], (json{{"axial_strain", 3.0}, {"deviator_stress", 300.0}, {"series", "test B"}}));
    EXPECT_EQ(layers[1]["encoding"]["shape"]["field"], "series");
    EXPECT_FALSE(figure.chart["vconcat"][1].contains("layer")); // no volumetric strain was measured
    EXPECT_NE(figure.caption.find("points.csv"), std::string::npos);
}

TEST(FigureOptions, PointsWithoutTheFiguresColumnsAreLeftAway) {
    Figure figure = sample_test();
    const json before = figure.chart;
    Points points;
    points.add("depth", "m", {1});
    EXPECT_FALSE(lay_over(figure, points, "points.csv"));
    EXPECT_EQ(figure.chart, before);
    Figure drawing = *erosion_loop(test::sample_erosion());
    EXPECT_FALSE(lay_over(drawing, points, "points.csv"));
}

TEST(FigureOptions, PointsThatNameAPanelLieInThatPanelOnly) {
    Figure figure = *void_ratios(test::sample_fines_study());
    Points points;
    points.add("fines_content", "%", {0, 20, 40});
    points.add("void_ratio", "-", {0.8, 0.6, 0.7});
    points.add("panel", {"a", "a", "b"});
    ASSERT_TRUE(lay_over(figure, points, "laboratory.csv"));
    const auto laid = [&](std::size_t panel) {
        return figure.chart["vconcat"][panel]["layer"].back()["data"]["values"];
    };
    EXPECT_EQ(laid(0).size(), 2U);
    ASSERT_EQ(laid(1).size(), 1U);
    EXPECT_EQ(laid(1)[0]["fines_content"], 40);
}

TEST(FigureOptions, PointsLieOverEachOfTheFirstSixFigures) {
    const study::FinesStudy study = test::sample_fines_study();
    const std::vector<std::pair<Figure, std::pair<const char*, const char*>>> figures = {
        {*mixture_gradings(test::sample_mixtures()), {"diameter", "passing"}},
        {*loose_compression(test::sample_loose_tests()), {"axial_strain", "deviator_stress"}},
        {*void_ratios(study), {"fines_content", "void_ratio"}},
        {*active_fines(study), {"fines_content", "active_fines"}},
        {*contact_classes(study), {"fines_content", "share_of_contacts"}},
        {*strong_contacts(study), {"fines_content", "strong_share"}}};
    for (auto [figure, columns] : figures) {
        Points points;
        points.add(columns.first, "", {0.1});
        points.add(columns.second, "", {0.2});
        EXPECT_TRUE(lay_over(figure, points, "laboratory.csv")) << figure.id;
    }
}

TEST(FigureOptions, LayeredChartsGetOneLayerMore) {
    Figure figure = *eroded_mass(test::sample_erosion());
    Points points;
    points.add("eroded_mass", "%", {10});
    EXPECT_FALSE(lay_over(figure, points, "p")); // its other axis is a word
    Figure curves = *grading_curves(test::sample_grading(), test::sample_grading(), 2.6e-4);
    Points sizes;
    sizes.add("diameter", "mm", {0.2});
    sizes.add("passing", "%", {40});
    const std::size_t layers = curves.chart.contains("layer") ? curves.chart["layer"].size() : 1;
    EXPECT_TRUE(lay_over(curves, sizes, "sieve.csv"));
    EXPECT_EQ(curves.chart["layer"].size(), layers + 1);
}

} // namespace
} // namespace suffuse::figures
