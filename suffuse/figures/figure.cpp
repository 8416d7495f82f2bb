#include "suffuse/figures/figure.hpp"

#include "suffuse/facts/by_key.hpp"
#include "suffuse/facts/shown.hpp"
#include "suffuse/record/or_null.hpp"

#include <fmt/format.h>

namespace suffuse::figures {

namespace {

using nlohmann::json;

json rows_of(const Table& table) {
    json rows = json::array();
    for (std::size_t row = 0; row < table.rows(); ++row) {
        json object = json::object();
        for (const Column& column : table.columns()) {
            if (const auto* words = std::get_if<std::vector<std::string>>(&column.values)) {
                object[column.name] = (*words)[row];
            } else {
                object[column.name] = or_null(std::get<std::vector<double>>(column.values)[row]);
            }
        }
        rows.push_back(std::move(object));
    }
    return rows;
}

/// The title of the fact that a channel shows, unless it has one.
void name_channel(json& channel, bool is_tooltip) {
    const bool has_field = channel.is_object() && channel.contains("field") && channel.at("field").is_string();
    const facts::Fact* const fact = has_field ? facts::shown_fact(channel.at("field").get<std::string>()) : nullptr;
    if (fact == nullptr || channel.contains("title")) {
        return;
    }
    channel["title"] = is_tooltip ? facts::short_title(fact->key) : facts::title(fact->key);
    if (is_tooltip && !channel.contains("format")) {
        channel["format"] = fmt::format(".{}g", fact->shown.digits);
    }
}

/// Names axes and tooltips of every panel and layer.
void name_facts(json& chart) {
    for (auto& [name, part] : chart.items()) {
        if (name == "encoding") {
            for (const char* axis : {"x", "y"}) {
                if (part.contains(axis)) {
                    name_channel(part[axis], false);
                }
            }
            if (part.contains("tooltip") && part["tooltip"].is_array()) {
                for (json& line : part["tooltip"]) {
                    name_channel(line, true);
                }
            }
        } else if (part.is_structured()) {
            name_facts(part);
        }
    }
}

} // namespace

std::optional<int> figure_of_paper(std::string_view id) {
    constexpr std::string_view start = "fig";
    return id.starts_with(start) ? std::optional(std::stoi(std::string(id.substr(start.size())))) : std::nullopt;
}

const json& color::sequence() {
    static const json colors = {"#3b82b8", "#d55e00", "#17ac5b", "#835380", "#c57c92", "#a74346"};
    return colors;
}

const json& color::dashes() {
    static const json dashes = json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2], [4, 2, 1, 2], [10, 3]]");
    return dashes;
}

json named_chart(const Figure& figure) {
    json chart = figure.chart;
    name_facts(chart);
    return chart;
}

json complete_specification(const Figure& figure) {
    json specification = named_chart(figure);
    specification["$schema"] = "https://vega.github.io/schema/vega-lite/v6.json";
    specification["description"] = figure.title + ". " + figure.caption;
    specification["data"] = {{"values", rows_of(figure.table)}};
    specification["config"] = look_in_print();
    return specification;
}

json look_in_print() {
    return json::parse(R"json({
        "font": "Helvetica, Arial, 'DejaVu Sans', sans-serif",
        "background": "white",
        "view": {"stroke": null},
        "axis": {
            "labelFontSize": 11, "titleFontSize": 12, "titleFontWeight": "normal", "titlePadding": 8,
            "labelColor": "#333333", "titleColor": "#111111", "domainColor": "#666666", "tickColor": "#666666",
            "gridColor": "#e4e4e4", "labelOverlap": true, "labelSeparation": 8
        },
        "legend": {
            "orient": "top", "labelFontSize": 11, "titleFontSize": 11, "titleFontWeight": "normal",
            "labelColor": "#333333", "titleColor": "#111111", "symbolStrokeWidth": 2, "labelLimit": 480,
            "symbolBaseFillColor": "#808080", "symbolBaseStrokeColor": "#808080"
        },
        "header": {"labelFontSize": 12, "labelColor": "#111111", "titleColor": "#111111", "labelLimit": 480},
        "text": {"fontSize": 11},
        "line": {"strokeWidth": 2}
    })json");
}

std::string power_of_ten_labels() {
    return "abs(log(datum.value) / LN10 - round(log(datum.value) / LN10)) > 1e-6 ? '' : '10' + "
           "['⁻²⁰','⁻¹⁹','⁻¹⁸','⁻¹⁷','⁻¹⁶','⁻¹⁵','⁻¹⁴','⁻¹³','⁻¹²','⁻¹¹','⁻¹⁰','⁻⁹','⁻⁸','⁻⁷','⁻⁶','⁻⁵','⁻⁴',"
           "'⁻³','⁻²','⁻¹','⁰','¹','²','³','⁴','⁵','⁶','⁷','⁸'][round(log(datum.value) / LN10) + 20]";
}

} // namespace suffuse::figures
