#include "suffuse/figures/figures_calibration.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/calibration_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::figures {
namespace {

using nlohmann::json;

/// A column of words that repeat.
json color_of_name(const std::vector<std::pair<const char*, const char*>>& names, const char* of) {
    json domain = json::array(), range = json::array();
    for (const auto& [name, color] : names) {
        domain.push_back(name);
        range.push_back(color);
    }
    return {
        {"datum", of},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", domain}, {"range", range}}},
        {"legend", {{"symbolOpacity", 1}}}};
}

/// "low, q/p₀: misfit 3.3 %"
std::string curve_panel(const CalibratedCurve& curve) {
    return fmt::format(
        "{}, {}: misfit {} %", curve.target, curve.quantity, short_number(100 * curve.relative_misfit, 2)
    );
}

/// Panels of equal width, as many in a row as fit.
json two_in_a_row(const std::vector<std::string>& panels, int width, json layers) {
    return {
        {"facet",
         {{"field", "panel"},
          {"type", "nominal"},
          {"title", nullptr},
          {"sort", panels},
          {"header", {{"labelAnchor", "start"}}}}},
        {"columns", 2},
        {"spec", {{"width", width}, {"height", 170}, {"layer", std::move(layers)}}}};
}

/// Band, model and laboratory. @param titles of the horizontal axis
json fit_layers(const std::vector<std::string>& titles) {
    const std::vector<std::pair<const char*, const char*>> names = {
        {"laboratory", color::coarse}, {"model", color::staying}};
    json x_axis = number_channel("x", titles.front() + (titles.size() > 1 ? "; oedometer: " + titles.back() : ""));
    x_axis["scale"] = {{"nice", false}};
    json band = {{"mark", {{"type", "area"}, {"opacity", 0.25}, {"color", color::staying}}}};
    band["encoding"] = {{"x", x_axis}, {"y", number_channel("low", nullptr)}, {"y2", {{"field", "high"}}}};
    json line = {{"mark", {{"type", "line"}}}};
    line["encoding"] = {
        {"x", x_axis}, {"y", number_channel("model", nullptr)}, {"color", color_of_name(names, "model")}};
    json points = {{"mark", {{"type", "point"}, {"filled", true}, {"size", 24}, {"opacity", 1}}}};
    points["encoding"] = {
        {"x", x_axis},
        {"y", number_channel("measured", nullptr)},
        {"color", color_of_name(names, "laboratory")},
        {"tooltip",
         {{{"field", "target"}},
          {{"field", "quantity"}},
          {{"field", "x"}, {"title", "at"}, {"format", ".4g"}},
          {{"field", "measured"}, {"title", "laboratory"}, {"format", ".4g"}},
          {{"field", "model"}, {"title", "model"}, {"format", ".4g"}}}}};
    return json::array({band, line, points});
}

json misfit_points() {
    json x = number_channel("place", "place in the range of the case [%]"), y = number_channel("misfit", "misfit [%]");
    x["scale"] = {{"domain", {0, 100}}};
    y["scale"] = {{"type", "log"}};
    y["axis"] = {{"tickCount", 4}, {"format", "~g"}};
    json points = {{"mark", {{"type", "point"}, {"filled", true}, {"size", 30}, {"opacity", 0.8}}}};
    points["transform"] = {{{"filter", "isValid(datum.misfit)"}}};
    points["encoding"] = {
        {"x", x},
        {"y", y},
        {"color",
         {{"field", "target"},
          {"type", "nominal"},
          {"title", nullptr},
          {"sort", nullptr},
          {"scale", {{"range", color::sequence()}}}}},
        {"tooltip",
         {{{"field", "target"}},
          {{"field", "round"}},
          {{"field", "value"}, {"format", ".4g"}},
          {{"field", "misfit"}, {"title", "misfit [%]"}, {"format", ".3g"}}}}};
    return points;
}

} // namespace

double CalibratedParameter::place(double value) const {
    return 100 * (is_log ? std::log(value / least) / std::log(most / least) : (value - least) / (most - least));
}

Figure calibration_intervals(const std::vector<CalibratedParameter>& parameters) {
    const auto open = std::ranges::count(parameters, false, &CalibratedParameter::is_identified);
    Figure figure = calibration_figure(
        "own-calibration-intervals", "Parameters", "Intervals in their ranges",
        open == 0 ? "The tests identify every parameter"
                  : fmt::format("The tests leave {} of {} parameters open", open, parameters.size())
    );
    std::vector<std::string> names, units, verdicts;
    std::vector<double> best, low, high, least, most, best_place, low_place, high_place;
    for (const CalibratedParameter& p : parameters) {
        names.push_back(p.name);
        units.push_back(p.unit);
        verdicts.emplace_back(p.is_identified ? "identified" : "not identified");
        best.push_back(p.best);
        low.push_back(p.low);
        high.push_back(p.high);
        least.push_back(p.least);
        most.push_back(p.most);
        best_place.push_back(p.place(p.best));
        low_place.push_back(p.place(p.low));
        high_place.push_back(p.place(p.high));
    }
    Table& table = figure.table;
    table.add("parameter", std::move(names));
    table.add("unit", std::move(units));
    table.add("verdict", std::move(verdicts));
    table.add("best", "", std::move(best));
    table.add("low", "", std::move(low));
    table.add("high", "", std::move(high));
    table.add("least", "", std::move(least));
    table.add("most", "", std::move(most));
    table.add("best_place", "%", std::move(best_place));
    table.add("low_place", "%", std::move(low_place));
    table.add("high_place", "%", std::move(high_place));
    figure.chart = json::parse(R"json({
        "width": 480, "height": {"step": 34},
        "layer": [
            {"mark": {"type": "rule", "strokeWidth": 7, "strokeCap": "round"},
             "encoding": {"x": {"field": "low_place", "type": "quantitative", "title": "place in the range of the case [%]",
                                "scale": {"domain": [0, 100]}},
                          "x2": {"field": "high_place"},
                          "color": {"field": "verdict", "type": "nominal", "title": null}}},
            {"mark": {"type": "point", "filled": true, "size": 60, "opacity": 1, "fill": "#ffffff", "stroke": "#333333", "strokeWidth": 2},
             "encoding": {"x": {"field": "best_place", "type": "quantitative"}}}
        ]
    })json");
    figure.chart["layer"][0]["encoding"]["color"]["scale"] = {
        {"domain", {"identified", "not identified"}}, {"range", {color::staying, color::fines}}};
    figure.chart["encoding"] = {
        {"y", {{"field", "parameter"}, {"type", "nominal"}, {"title", nullptr}, {"sort", nullptr}}},
        {"tooltip",
         {{{"field", "parameter"}},
          {{"field", "unit"}},
          {{"field", "best"}, {"title", "likeliest"}, {"format", ".4g"}},
          {{"field", "low"}, {"title", "from"}, {"format", ".4g"}},
          {{"field", "high"}, {"title", "to"}, {"format", ".4g"}}}}};
    figure.caption =
        "Bars: 90 % intervals; dots: the likeliest parameters together. 0 and 100 % are the ends of the range "
        "of the case; a bar that fills it has learned nothing from the tests.";
    return figure;
}

std::optional<Figure> calibration_fits(const std::vector<CalibratedCurve>& curves, bool are_held_out) {
    if (curves.empty()) {
        return std::nullopt;
    }
    const auto worst = std::ranges::max_element(curves, {}, &CalibratedCurve::relative_misfit);
    const std::string claim = fmt::format(
        "{} by up to {} % of the largest value",
        are_held_out ? "Predictions miss the tests held out" : "The model misses the tests",
        short_number(100 * worst->relative_misfit, 2)
    );
    Figure figure = are_held_out
                        ? calibration_figure("own-calibration-held-out", "Fit", "Tests that were held out", claim)
                        : calibration_figure("own-calibration-fit", "Fit", "Fit of the tests", claim);
    std::vector<std::string> panels, panel, target, quantity, titles;
    std::vector<double> x, measured, model, low, high;
    for (const CalibratedCurve& curve : curves) {
        panels.push_back(curve_panel(curve));
        if (std::ranges::find(titles, curve.x_title) == titles.end()) {
            titles.push_back(curve.x_title);
        }
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            panel.push_back(panels.back());
            target.push_back(curve.target);
            quantity.push_back(curve.quantity);
            x.push_back(curve.x[k]);
            measured.push_back(curve.measured[k]);
            model.push_back(curve.model[k]);
            low.push_back(curve.model[k] - curve.band[k]);
            high.push_back(curve.model[k] + curve.band[k]);
        }
    }
    Table& table = figure.table;
    table.add("panel", std::move(panel));
    table.add("target", std::move(target));
    table.add("quantity", std::move(quantity));
    table.add("x", "", std::move(x));
    table.add("measured", "", std::move(measured));
    table.add("model", "", std::move(model));
    table.add("low", "", std::move(low));
    table.add("high", "", std::move(high));
    figure.chart = two_in_a_row(panels, 300, fit_layers(titles));
    figure.chart["resolve"] = {{"scale", {{"x", "independent"}, {"y", "independent"}}}};
    figure.caption = are_held_out ? "Lines: means of samples of the posterior, eight unless some failed. Bands: where "
                                    "another such sample lies "
                                    "with a probability of 90 %, by Student's t for so few samples; none where only "
                                    "one succeeded. These tests "
                                    "were not fitted."
                                  : "Lines: the model at the likeliest parameters, by its emulator. Bands: where a "
                                    "sample of these parameters "
                                    "lies with a probability of 90 %, by Student's t: error of the emulator and "
                                    "scatter between samples. q is "
                                    "over the pressure at the start.";
    return figure;
}

std::optional<Figure> calibration_misfits(
    const std::vector<CalibratedParameter>& parameters, const std::vector<CalibrationSampleFit>& samples
) {
    const auto failed = std::ranges::count_if(samples, [](const auto& s) { return !std::isfinite(s.misfit); });
    if (samples.empty() || failed == std::ssize(samples)) {
        return std::nullopt;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const CalibrationSampleFit& sample : samples) {
        least = std::fmin(least, sample.misfit);
    }
    Figure figure = calibration_figure(
        "own-calibration-misfits", "Samples", "Misfits of the samples",
        fmt::format("The best of {} samples misses its test by {} %", samples.size(), short_number(100 * least, 2))
    );
    std::vector<std::string> panels, panel, target, round;
    std::vector<double> value, place, misfit;
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        panels.push_back(with_unit(parameters[k]));
        for (const CalibrationSampleFit& sample : samples) {
            panel.push_back(panels.back());
            target.push_back(sample.target);
            round.push_back(sample.round);
            value.push_back(sample.values[k]);
            place.push_back(parameters[k].place(sample.values[k]));
            misfit.push_back(100 * sample.misfit);
        }
    }
    Table& table = figure.table;
    table.add("panel", std::move(panel));
    table.add("target", std::move(target));
    table.add("round", std::move(round));
    table.add("value", "", std::move(value));
    table.add("place", "%", std::move(place));
    table.add("misfit", "%", std::move(misfit));
    figure.chart = two_in_a_row(panels, 300, json::array({misfit_points()}));
    figure.chart["spec"]["height"] = 140;
    figure.caption = fmt::format(
        "A point a sample: root mean square of model minus laboratory, over the largest measured value. Where points "
        "of one height reach over the whole range, the test says little about that parameter alone.{}",
        failed > 0 ? fmt::format(" {} samples failed and have no point.", failed) : ""
    );
    return figure;
}

} // namespace suffuse::figures
