#include "suffuse/figures/fines_chart.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using nlohmann::json;

constexpr int point_room = 6; ///< beyond the first and the last fines content, for the whole of their points [px]

json x_axis(const study::FinesStudy& study) {
    // Whole tens beyond the last fines content.
    const double last = study.fines_content.empty() ? 1 : study.fines_content.back();
    const double most = std::max(10.0, 10 * std::ceil(10 * last - 1e-9));
    return {
        {"field", "fines_content"},
        {"type", "quantitative"},
        {"title", "fines content FC, by mass [%]"},
        {"scale", {{"domain", {0, most}}, {"nice", false}, {"padding", point_room}}},
        {"axis", {{"tickCount", 10}}}};
}

/// A band, a rule and a name for each threshold. Names stand one below the other, the leftmost on top, and each rule
/// ends below the names to its left: no rule runs through a name.
void add_thresholds(std::vector<study::Threshold> thresholds, json& layers) {
    if (thresholds.empty()) {
        return;
    }
    std::sort(thresholds.begin(), thresholds.end(), [](const study::Threshold& a, const study::Threshold& b) {
        return a.at < b.at;
    });
    json values = json::array();
    for (const study::Threshold& each : thresholds) {
        const double row = 9 + 14 * static_cast<double>(values.size());
        values.push_back(
            {{"threshold", fmt::format("{}: {} %", each.name, short_number(100 * each.at))},
             {"at", 100 * each.at},
             {"from", 100 * each.low},
             {"to", 100 * each.high},
             {"top", row - 9},
             {"row", row}}
        );
    }
    json parts = json::parse(R"json([
        {"mark": {"type": "rect", "color": "#808080", "opacity": 0.14},
         "encoding": {"x": {"field": "from", "type": "quantitative"}, "x2": {"field": "to"}}},
        {"mark": {"type": "rule", "color": "#808080", "strokeDash": [4, 3]},
         "encoding": {"x": {"field": "at", "type": "quantitative"},
            "y": {"field": "top", "type": "quantitative", "scale": null, "axis": null}, "y2": {"value": "height"},
            "tooltip": [{"field": "threshold", "title": "threshold"}, {"field": "from", "title": "from [%]", "format": ".3g"},
                        {"field": "to", "title": "to [%]", "format": ".3g"}]}},
        {"mark": {"type": "text", "align": "left", "dx": 4, "color": "#333333"},
         "encoding": {"x": {"field": "at", "type": "quantitative"},
            "y": {"field": "row", "type": "quantitative", "scale": null, "axis": null},
            "text": {"field": "threshold", "type": "nominal"}}}
    ])json");
    for (json& part : parts) {
        part["data"]["values"] = values;
        layers.push_back(std::move(part));
    }
}

} // namespace

void FinesTable::add(const study::FinesStudy& study, const FinesLine& line, const std::string& panel) {
    for (std::size_t k = 0; k < line.curve->points.size(); ++k) {
        const study::SweepPoint& point = line.curve->points[k];
        const double specified = study.fines_content[k];
        const study::Scatter value = study::number_of(point, specified, line.number);
        if (value.seeds == 0) {
            continue;
        }
        const study::Scatter reached = study::number_of(point, specified, "fines_content");
        panel_.push_back(panel);
        quantity_.push_back(line.name);
        specified_.push_back(100 * specified);
        reached_.push_back(100 * (reached.seeds > 0 ? reached.mean : specified));
        mean_.push_back(factor_ * value.mean);
        deviation_.push_back(factor_ * value.standard_deviation);
        samples_.push_back(value.seeds);
    }
}

Table FinesTable::table() && {
    Table table;
    if (std::any_of(panel_.begin(), panel_.end(), [](const std::string& name) { return !name.empty(); })) {
        table.add("panel", std::move(panel_));
    }
    table.add("quantity", std::move(quantity_));
    table.add("fines_content", "%", std::move(specified_));
    table.add("fines_content_reached", "%", std::move(reached_));
    table.add(value_, unit_, std::move(mean_));
    table.add("standard_deviation", unit_, std::move(deviation_));
    table.add("samples", "", std::move(samples_));
    return table;
}

int FinesTable::most_samples() const {
    return samples_.empty() ? 0 : static_cast<int>(*std::max_element(samples_.begin(), samples_.end()));
}

json fines_panel(
    const study::FinesStudy& study, const std::vector<FinesLine>& lines, const std::string& value,
    const std::string& title, const std::vector<study::Threshold>& thresholds, const std::string& panel
) {
    json chart = {{"width", 480}, {"height", 240}, {"encoding", {{"x", x_axis(study)}}}, {"layer", json::array()}};
    if (!panel.empty()) {
        chart["name"] = panel;
    }
    add_thresholds(thresholds, chart["layer"]);
    json drawn = json::parse(R"json([
        {"mark": {"type": "line", "clip": true}, "encoding": {"y": {}}},
        {"mark": {"type": "rule", "clip": true, "strokeWidth": 1.5}, "encoding": {"y": {"field": "low"}, "y2": {"field": "high"}}},
        {"mark": {"type": "tick", "clip": true, "size": 7, "thickness": 1.5, "orient": "horizontal"}, "encoding": {"y": {"field": "low"}}},
        {"mark": {"type": "tick", "clip": true, "size": 7, "thickness": 1.5, "orient": "horizontal"}, "encoding": {"y": {"field": "high"}}},
        {"mark": {"type": "point", "filled": true, "size": 42, "opacity": 1}, "encoding": {"y": {}}}
    ])json");
    json names = json::array(), colors = json::array();
    for (const FinesLine& line : lines) {
        names.push_back(line.name);
        colors.push_back(line.color);
    }
    const bool has_bars = std::any_of(lines.begin(), lines.end(), [](const FinesLine& line) {
        return std::any_of(line.curve->points.begin(), line.curve->points.end(), [](const study::SweepPoint& point) {
            return point.seed.size() > 1;
        });
    });
    const json of_panel = {{{"filter", fmt::format("datum.panel == '{}'", panel)}}};
    for (json& layer : drawn) {
        json& y = layer["encoding"]["y"];
        const bool is_bar = y.contains("field");
        json transform = panel.empty() ? json::array() : of_panel;
        if (is_bar) {
            transform.push_back({{"filter", "datum.samples > 1"}});
            transform.push_back(
                {{"calculate", fmt::format("datum.{} - datum.standard_deviation", value)}, {"as", "low"}}
            );
            transform.push_back(
                {{"calculate", fmt::format("datum.{} + datum.standard_deviation", value)}, {"as", "high"}}
            );
        } else {
            y["field"] = value;
        }
        if (!transform.empty()) {
            layer["transform"] = transform;
        }
        y["type"] = "quantitative";
        y["title"] = title;
        layer["encoding"]["color"] = {
            {"field", "quantity"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", names}, {"range", colors}}},
            {"legend", {{"symbolType", "stroke"}, {"symbolOpacity", 1}, {"symbolSize", color::dash_symbol}}}};
    }
    drawn[0]["encoding"]["strokeDash"] = {
        {"field", "quantity"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", color::dashes()}}}};
    drawn[4]["encoding"]["tooltip"] = {
        {{"field", "quantity"}, {"title", "of"}},
        {{"field", "fines_content"}, {"title", "FC [%]"}, {"format", ".4g"}},
        {{"field", "fines_content_reached"}, {"title", "FC reached [%]"}, {"format", ".4g"}},
        {{"field", value}, {"title", title}, {"format", ".4g"}},
        {{"field", "standard_deviation"}, {"title", "standard deviation"}, {"format", ".2g"}},
        {{"field", "samples"}, {"title", "samples"}}};
    for (json& layer : drawn) {
        const std::string field = layer["encoding"]["y"]["field"];
        if (has_bars || (field != "low" && field != "high")) { // a scale over no numbers is complained of
            chart["layer"].push_back(std::move(layer));
        }
    }
    return chart;
}

std::string about_bars(int most_samples) {
    return most_samples > 1
               ? fmt::format(" Bars: one standard deviation over up to {} samples to each side.", most_samples)
               : " One sample a point, so no error bars.";
}

} // namespace suffuse::figures
