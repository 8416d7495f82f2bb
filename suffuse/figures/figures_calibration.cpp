#include "suffuse/figures/figures_calibration.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::figures {
namespace {

using nlohmann::json;

constexpr double normal_90 = 1.645;          // half the width of a 90 % interval, in standard deviations
constexpr std::size_t most_sets_drawn = 400; // samples of the posterior
constexpr std::size_t most_in_corner = 6;    // parameters
constexpr int histogram_bins = 16;           // of a histogram

std::string with_unit(const CalibratedParameter& parameter) {
    return parameter.unit.empty() ? parameter.name : fmt::format("{} [{}]", parameter.name, parameter.unit);
}

Figure calibration_figure(const char* id, const char* section, const char* title, std::string claim) {
    Figure figure;
    figure.id = id;
    figure.section = section;
    figure.title = title;
    figure.claim = std::move(claim);
    return figure;
}

json number_channel(const std::string& field, const json& title) {
    return {{"field", field}, {"type", "quantitative"}, {"title", title}};
}

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

/// A scale between these ends, logarithmic where all decades are as likely.
json range_scale(const CalibratedParameter& parameter, double low, double high) {
    return {{"type", parameter.is_log ? "log" : "linear"}, {"domain", {low, high}}, {"nice", false}, {"zero", false}};
}

/// The smallest and the largest value, with a margin.
std::pair<double, double>
drawn_ends(const CalibratedParameter& parameter, std::size_t column, const std::vector<std::vector<double>>& rows) {
    double low = rows.front()[column], high = low;
    for (const std::vector<double>& row : rows) {
        low = std::min(low, row[column]);
        high = std::max(high, row[column]);
    }
    if (low >= high) {
        return {parameter.least, parameter.most};
    }
    if (parameter.is_log) {
        const double margin = std::pow(high / low, 0.03);
        return {low / margin, high * margin};
    }
    const double margin = 0.03 * (high - low);
    return {low - margin, high + margin};
}

/// Axes of a panel that stands with others in rows and columns: shown at the left and at the bottom alone. A vertical
/// one has always the same room, so that columns are straight.
json corner_axis(const std::string& title, bool is_vertical) {
    constexpr int room = 46; // [px]
    json axis = {{"grid", false}, {"tickCount", 3}, {"labelOverlap", "greedy"}, {"format", ".3~g"}, {"title", title}};
    if (is_vertical) {
        axis.update({{"minExtent", room}, {"maxExtent", room}});
    }
    return axis;
}

json without_labels(json axis) {
    axis.update({{"labels", false}, {"ticks", false}, {"title", nullptr}});
    return axis;
}

/// The share of the samples in each of some bins.
json value_histogram(const CalibratedParameter& p, double low, double high, json x_axis) {
    const auto on_scale = [&](double value) { return p.is_log ? std::log10(value) : value; };
    const std::string number = fmt::format("datum['{}']", p.field);
    const auto back = [&](const char* end) {
        return p.is_log ? fmt::format("pow(10, datum.{})", end) : fmt::format("datum.{}", end);
    };
    json panel = {{"height", 90}, {"width", 90}, {"mark", {{"type", "bar"}, {"binSpacing", 0}}}};
    panel["transform"] = {
        {{"calculate", p.is_log ? fmt::format("log({}) / LN10", number) : number}, {"as", "on_scale"}},
        {{"bin",
          {{"extent", {on_scale(low), on_scale(high)}}, {"step", (on_scale(high) - on_scale(low)) / histogram_bins}}},
         {"field", "on_scale"},
         {"as", {"from", "to"}}},
        {{"aggregate", {{{"op", "count"}, {"as", "samples"}}}}, {"groupby", {"from", "to"}}},
        {{"calculate", back("from")}, {"as", "begin"}},
        {{"calculate", back("to")}, {"as", "end"}}};
    json x = number_channel("begin", nullptr);
    x.erase("title");
    x["scale"] = range_scale(p, low, high);
    x["axis"] = x_axis;
    panel["encoding"] = {
        {"x", x},
        {"x2", {{"field", "end"}}},
        {"y", number_channel("samples", nullptr)},
        {"y2", {{"datum", 0}}},
        {"color", {{"value", color::staying}}},
        {"tooltip",
         {{{"field", "begin"}, {"title", "from"}, {"format", ".4g"}},
          {{"field", "end"}, {"title", "to"}, {"format", ".4g"}},
          {{"field", "samples"}, {"title", "samples"}}}}};
    panel["encoding"]["y"]["axis"] = nullptr;
    return panel;
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
            low.push_back(curve.model[k] - normal_90 * curve.error[k]);
            high.push_back(curve.model[k] + normal_90 * curve.error[k]);
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
    figure.chart = two_in_a_row(panels, 300, {band, line, points});
    figure.chart["resolve"] = {{"scale", {{"x", "independent"}, {"y", "independent"}}}};
    figure.caption = are_held_out ? "Predictions: means and 90 % bands of eight samples of the posterior, their "
                                    "scatter included. These tests "
                                    "were not fitted."
                                  : "Lines: the model at the likeliest parameters, by its emulator. Bands: 90 % of the "
                                    "error of the emulator, which "
                                    "has the scatter between samples in it. q is over the pressure at the start.";
    return figure;
}

std::optional<Figure>
calibration_corner(const std::vector<CalibratedParameter>& all, const std::vector<std::vector<double>>& posterior) {
    if (all.size() < 2 || posterior.size() < 2) {
        return std::nullopt;
    }
    const std::size_t count = std::min(all.size(), most_in_corner),
                      step = std::max<std::size_t>(1, posterior.size() / most_sets_drawn);
    const std::vector<CalibratedParameter> parameters(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    Figure figure = calibration_figure("own-calibration-corner", "Parameters", "Posterior of each pair", "");
    std::vector<std::vector<double>> drawn;
    for (std::size_t k = 0; k < posterior.size(); k += step) {
        drawn.push_back(posterior[k]);
    }
    json rows = json::array();
    for (std::size_t a = 0; a < count; ++a) {
        const bool is_last = a + 1 == count;
        std::vector<double> values;
        for (const std::vector<double>& row : drawn) {
            values.push_back(row[a]);
        }
        figure.table.add(parameters[a].field, parameters[a].unit, std::move(values));
        json panels = json::array();
        const auto [low, high] = drawn_ends(parameters[a], a, posterior);
        for (std::size_t b = 0; b < a; ++b) {
            const auto [left, right] = drawn_ends(parameters[b], b, posterior);
            json x = number_channel(parameters[b].field, with_unit(parameters[b])),
                 y = number_channel(parameters[a].field, with_unit(parameters[a]));
            x["scale"] = range_scale(parameters[b], left, right);
            y["scale"] = range_scale(parameters[a], low, high);
            x["axis"] = is_last ? corner_axis(with_unit(parameters[b]), false) : without_labels(corner_axis("", false));
            y["axis"] = b == 0 ? corner_axis(with_unit(parameters[a]), true) : json(nullptr);
            json panel = {
                {"width", 90},
                {"height", 90},
                {"mark", {{"type", "point"}, {"filled", true}, {"size", 8}, {"opacity", 0.35}}}};
            panel["encoding"] = {{"x", x}, {"y", y}, {"color", {{"value", color::staying}}}};
            panels.push_back(std::move(panel));
        }
        const json below = corner_axis(with_unit(parameters[a]), false);
        json diagonal = value_histogram(parameters[a], low, high, is_last ? below : without_labels(below));
        if (a == 0) { // as wide as the axes of the rows below
            diagonal["encoding"]["y"]["axis"] = without_labels(corner_axis("", true));
            diagonal["encoding"]["y"]["axis"]["title"] = " ";
        }
        panels.push_back(std::move(diagonal));
        rows.push_back({{"hconcat", std::move(panels)}, {"spacing", 8}});
    }
    figure.chart = {{"vconcat", std::move(rows)}, {"spacing", 8}};
    figure.caption = fmt::format(
        "{} of {} equally likely sets of parameters; all are in posterior.csv. On the diagonal: how often each value "
        "occurs. "
        "A narrow slanted cloud: the two parameters replace each other.{}",
        drawn.size(), posterior.size(),
        count < all.size() ? fmt::format(" The first {} of {} parameters.", count, all.size()) : ""
    );
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
    figure.chart = two_in_a_row(panels, 300, json::array({points}));
    figure.chart["spec"]["height"] = 140;
    figure.caption = fmt::format(
        "A point a sample: root mean square of model minus laboratory, over the largest measured value. Where points "
        "of one "
        "height reach over the whole range, the test says little about that parameter alone.{}",
        failed > 0 ? fmt::format(" {} samples failed and have no point.", failed) : ""
    );
    return figure;
}

} // namespace suffuse::figures
