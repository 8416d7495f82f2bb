#include "suffuse/figures/stability_view.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/size_axis.hpp"
#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::figures {

namespace {

using nlohmann::json;
using stability::Assessment;
using stability::Criterion;

constexpr double to_mm = 1e3, to_percent = 100;

/// Rows of a figure whose curves and marks stand in one table.
struct Points {
    std::vector<std::string> curve, label;
    std::vector<double> x, y;

    void add(const std::string& name, double px, double py, const std::string& text = {}) {
        curve.push_back(name);
        x.push_back(px);
        y.push_back(py);
        label.push_back(text);
    }
};

/// "≥ 1.3", where the terminal has ">= 1.3".
std::string typeset_limit(const Criterion& criterion) {
    std::string text = stability::limit_text(criterion);
    if (criterion.limit && !criterion.upper && !criterion.strict) {
        text.replace(0, 2, criterion.sense == stability::Sense::AtMost ? "≤" : "≥");
    }
    return text;
}

std::vector<std::string> row_of(const Criterion& criterion, const std::string& verdict) {
    return {
        criterion.name,
        criterion.verified ? verdict : verdict + " (unverified)",
        criterion.value ? short_number(*criterion.value) : "–",
        typeset_limit(criterion),
        criterion.measure,
        criterion.remark,
        criterion.source};
}

/// The curve and its marks over sizes from `from` to `to` [mm].
json grading_layers(const Assessment& assessment, double from, double to, GradingAxis axis) {
    json layers = json::array();
    if (assessment.fines) {
        layers = fines_layers(from, std::min(to, to_mm * assessment.fines->finer_than), axis == GradingAxis::Reversed);
    }
    for (json& layer : class_layers(from, to)) {
        layers.push_back(std::move(layer));
    }
    if (assessment.gap) {
        const json gap = {
            {{"from", to_mm * assessment.gap->fine_end}, {"to", to_mm * assessment.gap->coarse_end}, {"text", "gap"}}};
        layers.push_back(
            {{"data", {{"values", gap}}},
             {"mark", {{"type", "rect"}, {"color", color::quiet}, {"opacity", 0.18}}},
             {"encoding", {{"x", {{"field", "from"}, {"type", "quantitative"}}}, {"x2", {{"field", "to"}}}}}}
        );
    }
    for (const json& layer : json::parse(R"json([
        {"transform": [{"filter": "datum.curve == 'grading'"}],
         "mark": {"type": "line", "strokeWidth": 2.2},
         "encoding": {"x": {"field": "diameter", "type": "quantitative"},
                      "y": {"field": "passing", "type": "quantitative", "title": "passing by mass F [%]",
                            "scale": {"domain": [0, 100]}},
                      "order": {"field": "diameter"}}},
        {"transform": [{"filter": "datum.curve == 'marks'"}],
         "mark": {"type": "point", "filled": true, "size": 45, "opacity": 1},
         "encoding": {"x": {"field": "diameter", "type": "quantitative"},
                      "y": {"field": "passing", "type": "quantitative"},
                      "tooltip": [{"field": "label", "title": "size"},
                                  {"field": "diameter", "title": "d [mm]", "format": ".4g"}]}},
        {"transform": [{"filter": "datum.curve == 'marks'"}],
         "mark": {"type": "text", "align": "right", "dx": -7, "dy": -4},
         "encoding": {"x": {"field": "diameter", "type": "quantitative"},
                      "y": {"field": "passing", "type": "quantitative"},
                      "text": {"field": "label"}}}
    ])json")) {
        layers.push_back(layer);
    }
    const std::size_t line = layers.size() - 3;
    layers[line]["mark"]["color"] = color::staying;
    layers[line + 1]["mark"]["color"] = color::detachable;
    return layers;
}

/// Limits in the H-F plane, as far as each reaches.
void add_limits(const Assessment& assessment, Points& points) {
    const double end = to_percent * assessment.finer_limit;
    for (const double f : {0.0, end}) {
        points.add("H = F, Kenney and Lau 1986", f, f);
        points.add("H = 1.3 F, Kenney and Lau 1985", f, 1.3 * f);
    }
    for (const double f : {0.0, 85.0}) {
        points.add("H = 15 %, Kezdi", f, 15);
    }
}

} // namespace

PageTable stability_table(const Assessment& assessment) {
    PageTable table;
    table.section = "Soils";
    table.title = "Internal stability by the grading";
    table.note = as_sentence(stability::summary(assessment.criteria)) +
                 ". Criteria whose limits were not read in a source are marked unverified and not counted.";
    table.header = {"criterion", "verdict", "number", "stable if", "measure", "remark", "source"};
    table.numeric = {false, false, true, false, false, false, false};
    for (const auto* list : {&assessment.criteria, &assessment.gradients}) {
        for (const Criterion& criterion : *list) {
            table.rows.push_back(row_of(criterion, stability::verdict_word(criterion.verdict)));
        }
    }
    return table;
}

PageTable filter_table(const stability::FilterCheck& check, const std::string& filter) {
    PageTable table;
    table.section = "Soils";
    table.title = "The filter " + filter;
    table.note = as_sentence(stability::filter_summary(check)) +
                 ". Rules whose limits were not read in a source are not counted.";
    table.header = {"rule", "verdict", "number", "holds if", "measure", "remark", "source"};
    table.numeric = {false, false, true, false, false, false, false};
    for (const Criterion& criterion : check.criteria) {
        table.rows.push_back(row_of(criterion, stability::filter_word(criterion.verdict)));
    }
    return table;
}

Figure stability_grading(const Assessment& assessment, GradingAxis axis) {
    const grains::Grading& grading = assessment.grading;
    Points points;
    // Ends that were not measured were completed for the criteria; they are not drawn.
    const double lowest = assessment.missing_fine, highest = 1 - assessment.missing_coarse;
    const auto is_measured = [&](double passing) { return passing >= lowest && passing <= highest; };
    for (std::size_t k = 0; k < grading.diameter.size(); ++k) {
        if (is_measured(grading.passing[k])) {
            points.add("grading", to_mm * grading.diameter[k], to_percent * grading.passing[k]);
        }
    }
    for (const int percent : {10, 15, 50, 60, 85, 90}) {
        if (const double share = percent / 100.0; is_measured(share)) {
            points.add("marks", to_mm * grains::size_at(grading, share), percent, fmt::format("d{}", percent));
        }
    }
    const double from = to_mm * grading.diameter.front() / 1.15, to = to_mm * grading.diameter.back() * 1.15;
    Figure figure;
    figure.id = "own-stability-grading";
    figure.section = "Soils";
    figure.title = "Grading, and the sizes that criteria of internal stability read";
    const bool knows_uniformity = is_measured(0.1) && is_measured(0.6);
    figure.caption = fmt::format(
        "{}{}{}.",
        knows_uniformity ? "D60/D10 = " + short_number(grains::uniformity(grading)) : "D60/D10 was not measured",
        assessment.gap
            ? fmt::format(
                  "; sizes from {} to {} mm are missing (gray)", short_number(to_mm * assessment.gap->fine_end),
                  short_number(to_mm * assessment.gap->coarse_end)
              )
            : "; no gap",
        assessment.fines
            ? fmt::format(
                  "; {} % of the mass are finer than {} mm ({})", short_number(to_percent * assessment.fines->content),
                  short_number(to_mm * assessment.fines->finer_than), stability::basis_text(assessment.fines->basis)
              )
            : "; no fine fraction stands out"
    );
    figure.table.add("curve", std::move(points.curve));
    figure.table.add("diameter", "mm", std::move(points.x));
    figure.table.add("passing", "%", std::move(points.y));
    figure.table.add("label", std::move(points.label));
    figure.chart = {
        {"width", 560},
        {"height", 300},
        {"encoding", {{"x", size_axis(from, to, axis == GradingAxis::Reversed)}}},
        {"layer", grading_layers(assessment, from, to, axis)}};
    return figure;
}

Figure stability_shape(const Assessment& assessment) {
    Points points;
    for (const stability::ShapePoint& point : stability::shape_curve(assessment.grading)) {
        points.add("this soil", to_percent * point.finer, to_percent * point.increment);
    }
    add_limits(assessment, points);
    const auto least = std::find_if(assessment.criteria.begin(), assessment.criteria.end(), [](const Criterion& each) {
        return each.id == "kenney-lau-1986";
    });
    Figure figure;
    figure.id = "own-stability-shape";
    figure.section = "Soils";
    figure.title = "Shape of the grading: H(d) = F(4d) − F(d) over F(d)";
    figure.caption = fmt::format(
        "Least H/F{}; unstable where the curve falls below H = F (1986) or 1.3 F (1985). Li and Fannin call the area "
        "below both H = F and 15 % unstable.",
        least->value ? fmt::format(" = {} {}", short_number(*least->value), least->remark) : ": " + least->remark
    );
    figure.table.add("curve", std::move(points.curve));
    figure.table.add("finer", "%", std::move(points.x));
    figure.table.add("increment", "%", std::move(points.y));
    figure.chart = json::parse(R"json({
        "width": 420, "height": 300,
        "transform": [{"window": [{"op": "row_number", "as": "along"}]}],
        "mark": {"type": "line", "strokeWidth": 2.2, "clip": true},
        "encoding": {
            "x": {"field": "finer", "type": "quantitative", "title": "passing by mass F [%]",
                  "scale": {"domain": [0, 50]}},
            "y": {"field": "increment", "type": "quantitative", "title": "mass from d to 4d, H [%]",
                  "scale": {"domain": [0, 100]}},
            "color": {"field": "curve", "type": "nominal", "title": null, "legend": {"columns": 2}},
            "strokeDash": {"field": "curve", "type": "nominal", "title": null},
            "order": {"field": "along"},
            "tooltip": [{"field": "curve", "title": "curve"}, {"field": "finer", "title": "F [%]", "format": ".3g"},
                        {"field": "increment", "title": "H [%]", "format": ".3g"}]
        }
    })json");
    const json order = {"this soil", "H = F, Kenney and Lau 1986", "H = 1.3 F, Kenney and Lau 1985", "H = 15 %, Kezdi"};
    figure.chart["encoding"]["color"]["scale"] = {
        {"domain", order}, {"range", {color::staying, color::fines, color::detachable, color::quiet}}};
    figure.chart["encoding"]["strokeDash"]["scale"] = {
        {"domain", order}, {"range", json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]")}};
    return figure;
}

} // namespace suffuse::figures
