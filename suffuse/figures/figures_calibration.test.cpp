#include "suffuse/figures/figures_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse::figures {
namespace {

CalibratedParameter parameter(const char* name, double least, double most, bool is_log = false) {
    CalibratedParameter p;
    p.name = p.field = name;
    p.least = least;
    p.most = most;
    p.is_log = is_log;
    p.best = p.low = p.high = least;
    return p;
}

CalibratedCurve curve(const char* target, double misfit) {
    return {target, "q/p₀", "axial strain [%]", {1, 2}, {1, 2}, {1.5, 2.5}, {0.1, 0.2}, misfit};
}

TEST(CalibrationFigures, APlaceInARangeOfDecadesIsThatOfTheLogarithms) {
    EXPECT_NEAR(parameter("a", 1, 100, true).place(10), 50, 1e-12);
    EXPECT_NEAR(parameter("a", 1, 101).place(51), 50, 1e-12);
}

TEST(CalibrationFigures, AnOpenParameterIsCountedInTheClaimAndColoredByItsVerdict) {
    std::vector<CalibratedParameter> parameters = {parameter("a", 0, 1), parameter("b", 0, 1)};
    EXPECT_EQ(calibration_intervals(parameters).claim, "The tests identify every parameter");
    parameters[1].is_identified = false;
    const Figure figure = calibration_intervals(parameters);
    EXPECT_EQ(figure.claim, "The tests leave 1 of 2 parameters open");
    EXPECT_EQ(figure.table.words("verdict"), (std::vector<std::string>{"identified", "not identified"}));
}

TEST(CalibrationFigures, TheBandOfAFitIsOnBothSidesAndNamesItsMeaning) {
    const Figure figure = *calibration_fits({curve("low", 0.03), curve("high", 0.2)}, false);
    EXPECT_NEAR(figure.table.numbers("low")[0], 1.5 - 0.1, 1e-12);
    EXPECT_NEAR(figure.table.numbers("high")[1], 2.5 + 0.2, 1e-12);
    EXPECT_NE(figure.caption.find("by Student's t"), std::string::npos);
    EXPECT_EQ(figure.chart["facet"]["sort"].size(), 2U);
    EXPECT_EQ(figure.claim, "The model misses the tests by up to 20 % of the largest value");
    EXPECT_EQ(figure.id, "own-calibration-fit");
    EXPECT_EQ(calibration_fits({curve("low", 0.03)}, true)->id, "own-calibration-held-out");
    EXPECT_FALSE(calibration_fits({}, true));
}

TEST(CalibrationFigures, ACornerHasAPanelForEachPairAndAHistogramForEachParameter) {
    std::vector<std::vector<double>> posterior;
    for (int k = 0; k < 2000; ++k) {
        posterior.push_back({0.001 * k, 1.0 + 0.001 * k, 5.0});
    }
    const std::vector<CalibratedParameter> parameters = {
        parameter("a", 0, 2), parameter("b", 1, 3, true), parameter("c", 0, 10)};
    const Figure figure = *calibration_corner(parameters, posterior);
    ASSERT_EQ(figure.chart["vconcat"].size(), 3U);
    for (std::size_t row = 0; row < 3; ++row) {
        EXPECT_EQ(figure.chart["vconcat"][row]["hconcat"].size(), row + 1);
    }
    EXPECT_EQ(figure.table.rows(), 400U);
    const nlohmann::json& x = figure.chart["vconcat"][2]["hconcat"][1]["encoding"]["x"];
    EXPECT_EQ(x["field"], "b");
    EXPECT_EQ(x["scale"]["type"], "log");
    EXPECT_EQ(figure.chart["vconcat"][2]["hconcat"][2]["encoding"]["x"]["scale"]["domain"], nlohmann::json({0.0, 10.0}))
        << "values that are all the same are shown in their range";
    EXPECT_FALSE(calibration_corner({parameters[0]}, posterior));
}

TEST(CalibrationFigures, SamplesThatFailedHaveNoPointAndAreCounted) {
    const std::vector<CalibrationSampleFit> samples = {
        {"low", "round-1", 0.5, {0.1, 0.2}}, {"low", "round-1", missing, {0.3, 0.4}}};
    const Figure figure = *calibration_misfits({parameter("a", 0, 1), parameter("b", 0, 1)}, samples);
    EXPECT_EQ(figure.table.rows(), 4U);
    EXPECT_NEAR(figure.table.numbers("misfit")[0], 50, 1e-12);
    EXPECT_TRUE(std::isnan(figure.table.numbers("misfit")[1]));
    EXPECT_NE(figure.caption.find("1 samples failed"), std::string::npos);
    EXPECT_FALSE(calibration_misfits({parameter("a", 0, 1)}, {samples[1]}));
}

} // namespace
} // namespace suffuse::figures
