#include "suffuse/figures/figure_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using nlohmann::json;

bool has_column(const Table& table, const json& channel) {
    if (!channel.is_object() || !channel.contains("field")) {
        return false;
    }
    const auto& columns = table.columns();
    return std::any_of(columns.begin(), columns.end(), [&](const Column& column) {
        return column.name == channel["field"] && std::holds_alternative<std::vector<double>>(column.values);
    });
}

/// The words of a column, or null where there is no such column of words.
const std::vector<std::string>* words_of(const Table& points, const std::string& name) {
    for (const Column& column : points.columns()) {
        if (column.name == name) {
            return std::get_if<std::vector<std::string>>(&column.values);
        }
    }
    return nullptr;
}

/// Rows that have both coordinates, and belong into the panel where they name one.
json point_values(const Table& points, const std::string& x, const std::string& y, const std::string& panel) {
    json values = json::array();
    const std::vector<std::string>* panels = words_of(points, "panel");
    const std::vector<double>&xs = points.numbers(x), &ys = points.numbers(y);
    for (std::size_t row = 0; row < points.rows(); ++row) {
        const bool is_elsewhere = panels != nullptr && !panel.empty() && (*panels)[row] != panel;
        if (!std::isfinite(xs[row]) || !std::isfinite(ys[row]) || is_elsewhere) {
            continue;
        }
        json point = {{x, xs[row]}, {y, ys[row]}};
        for (const Column& column : points.columns()) {
            if (const auto* words = std::get_if<std::vector<std::string>>(&column.values); words != nullptr) {
                point[column.name] = (*words)[row];
            }
        }
        values.push_back(std::move(point));
    }
    return values;
}

json point_layer(const Table& points, const json& x, const json& y, const std::string& panel) {
    json layer = {
        {"data", {{"values", point_values(points, x["field"], y["field"], panel)}}},
        {"mark", {{"type", "point"}, {"size", 45}, {"stroke", color::quiet}, {"strokeWidth", 1.5}, {"filled", false}}},
        {"encoding", {{"x", x}, {"y", y}}}};
    if (words_of(points, "series") != nullptr) {
        layer["encoding"]["shape"] = {{"field", "series"}, {"type", "nominal"}, {"title", nullptr}};
    }
    return layer;
}

/// One panel: a mark of its own becomes the first of its layers.
bool lay_over_panel(json& panel, const Table& points) {
    const json none = json::object();
    const json encoding = panel.value("encoding", none);
    if (!panel.contains("layer")) {
        const json x = encoding.value("x", none), y = encoding.value("y", none);
        if (!has_column(points, x) || !has_column(points, y)) {
            return false;
        }
        panel["layer"] = {
            {{"mark", panel["mark"]}, {"encoding", encoding}}, point_layer(points, x, y, panel.value("name", ""))};
        panel.erase("mark");
        panel.erase("encoding");
        return true;
    }
    for (const json& layer : json(panel["layer"])) { // a copy: the list grows
        const json own = layer.value("encoding", none);
        const json x = own.value("x", encoding.value("x", none)), y = own.value("y", encoding.value("y", none));
        if (has_column(points, x) && has_column(points, y)) {
            panel["layer"].push_back(point_layer(points, x, y, panel.value("name", "")));
            return true;
        }
    }
    return false;
}

void turn_strain_over(json& part) {
    if (part.is_object()) {
        if (part.contains("y") && part["y"].is_object() && part["y"].value("field", "") == "volumetric_strain") {
            part["y"]["scale"]["reverse"] = true;
        }
    }
    if (part.is_structured()) {
        for (json& each : part) {
            turn_strain_over(each);
        }
    }
}

} // namespace

std::string figure_id(const std::string& word) {
    std::string rest = word;
    for (const std::string_view front : {"figure-", "figure", "fig"}) {
        if (rest.starts_with(front)) {
            rest.erase(0, front.size());
            break;
        }
    }
    const bool is_number =
        !rest.empty() && rest.size() <= 3 && rest.find_first_not_of("0123456789") == std::string::npos;
    return is_number ? fmt::format("fig{:02}", std::stoi(rest)) : word;
}

bool is_requested(const std::vector<std::string>& words, const Figure& figure) {
    const bool of_paper = figure_of_paper(figure.id).has_value();
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return word == (of_paper ? "paper" : "own") || figure_id(word) == figure.id;
    });
}

void draw_dilation_up(Figure& figure) {
    turn_strain_over(figure.chart);
}

bool lay_over(Figure& figure, const Points& points, const std::string& source) {
    if (!figure.drawing.empty()) {
        return false;
    }
    bool is_laid = false;
    if (figure.chart.contains("vconcat")) {
        for (json& panel : figure.chart["vconcat"]) {
            is_laid = lay_over_panel(panel, points) || is_laid;
        }
    } else if (figure.chart.contains("spec")) { // of a facet: the same points in every panel
        is_laid = lay_over_panel(figure.chart["spec"], points);
    } else {
        is_laid = lay_over_panel(figure.chart, points);
    }
    if (is_laid) {
        figure.caption += " Open markers: measured, " + source + ".";
    }
    return is_laid;
}

} // namespace suffuse::figures
