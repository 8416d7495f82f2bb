#include "suffuse/report/stress_probes.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::report {
namespace {

using nlohmann::json;

bool is_unstable(const ProbedDirection& direction) {
    return direction.answer == "fails" || direction.normalized_work <= 0;
}

/// As literature draws it: a direction without second-order work lies on the circle of radius 1, with the most that it
/// can have on that of radius 2. Curves are closed.
Table probe_table(const std::vector<ProbedSample>& samples) {
    std::vector<std::string> sample, answer;
    std::vector<double> row, angle, work, axial_stress, lateral_stress, axial_strain, lateral_strain;
    for (const ProbedSample& each : samples) {
        for (std::size_t k = 0; k <= each.directions.size(); ++k) {
            const ProbedDirection& d = each.directions[k % each.directions.size()];
            sample.push_back(each.name);
            row.push_back(static_cast<double>(k));
            angle.push_back(degrees(d.angle) + (k == each.directions.size() ? 360 : 0));
            work.push_back(d.normalized_work);
            axial_stress.push_back(d.axial_stress / 1e3);
            lateral_stress.push_back(d.lateral_stress / 1e3);
            axial_strain.push_back(100 * d.axial_strain);
            lateral_strain.push_back(100 * d.lateral_strain);
            answer.push_back(d.answer);
        }
    }
    Table table;
    table.add("sample", std::move(sample));
    table.add("row", "", std::move(row));
    table.add("angle", "deg", std::move(angle));
    table.add("normalized_work", "-", std::move(work));
    table.add("axial_stress", "kPa", std::move(axial_stress));
    table.add("lateral_stress", "kPa", std::move(lateral_stress));
    table.add("axial_strain", "%", std::move(axial_strain));
    table.add("lateral_strain", "%", std::move(lateral_strain));
    table.add("answer", std::move(answer));
    return table;
}

const char* const chart_text = R"json({
    "transform": [
        {"calculate": "(1 + datum.normalized_work) * cos(datum.angle * PI / 180)", "as": "circle_x"},
        {"calculate": "(1 + datum.normalized_work) * sin(datum.angle * PI / 180)", "as": "circle_y"},
        {"calculate": "SQRT2 * datum.lateral_strain", "as": "lateral_size"}],
    "hconcat": [
        {"width": 270, "height": 270,
         "title": {"text": "second-order work W₂ of each load", "fontWeight": "normal", "fontSize": 12},
         "layer": [
            {"data": {"sequence": {"start": 0, "stop": 361, "step": 4, "as": "turn"}},
             "transform": [{"calculate": "cos(datum.turn * PI / 180)", "as": "x"},
                           {"calculate": "sin(datum.turn * PI / 180)", "as": "y"}],
             "mark": {"type": "line", "color": "#808080", "strokeDash": [4, 3], "strokeWidth": 1.2},
             "encoding": {"x": {"field": "x", "type": "quantitative"}, "y": {"field": "y", "type": "quantitative"},
                          "order": {"field": "turn"}}},
            {"data": {"values": [{"x": 0, "y": 0, "text": "W₂ < 0"}]},
             "mark": {"type": "text", "color": "#808080", "fontSize": 11},
             "encoding": {"x": {"field": "x", "type": "quantitative"}, "y": {"field": "y", "type": "quantitative"},
                          "text": {"field": "text"}}},
            {"mark": {"type": "line", "point": {"size": 22}},
             "encoding": {
                "x": {"field": "circle_x", "type": "quantitative", "title": "toward lateral stress √2 dσ₃ →",
                      "scale": {"domain": [-2.1, 2.1], "nice": false}, "axis": {"labels": false, "ticks": false, "grid": false}},
                "y": {"field": "circle_y", "type": "quantitative", "title": "toward axial stress dσ₁ →",
                      "scale": {"domain": [-2.1, 2.1], "nice": false}, "axis": {"labels": false, "ticks": false, "grid": false}},
                "order": {"field": "row"}}}]},
        {"width": 270, "height": 270,
         "title": {"text": "strain that each load leads to", "fontWeight": "normal", "fontSize": 12},
         "mark": {"type": "line", "point": {"size": 22}},
         "encoding": {
            "x": {"field": "lateral_size", "type": "quantitative", "title": "√2 dε₃ [%]"},
            "y": {"field": "axial_strain", "type": "quantitative", "title": "dε₁ [%]"},
            "order": {"field": "row"}}}
    ],
    "spacing": 24,
    "resolve": {"scale": {"color": "shared"}}
})json";

/// "180° to 210°": the directions as ranges of neighbors.
std::string ranges_of(const std::vector<ProbedDirection>& directions) {
    std::string text;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        if (!is_unstable(directions[k])) {
            continue;
        }
        std::size_t last = k;
        while (last + 1 < directions.size() && is_unstable(directions[last + 1])) {
            ++last;
        }
        text += text.empty() ? "" : ", ";
        text += fmt::format("{:.0f}°", degrees(directions[k].angle));
        text += last == k ? "" : fmt::format(" to {:.0f}°", degrees(directions[last].angle));
        k = last;
    }
    return text;
}

} // namespace

std::string tell_stability(const ProbedSample& sample) {
    const auto least =
        std::min_element(sample.directions.begin(), sample.directions.end(), [](const auto& a, const auto& b) {
            return a.normalized_work < b.normalized_work;
        });
    const std::string where = fmt::format(
        "the least normalized second-order work is {} at {:.0f}°", short_number(least->normalized_work, 3),
        degrees(least->angle)
    );
    const auto unstable = std::count_if(sample.directions.begin(), sample.directions.end(), is_unstable);
    if (unstable == 0) {
        return fmt::format(
            "{}: stable in all {} directions of load; {}.", sample.name, sample.directions.size(), where
        );
    }
    return fmt::format(
        "{}: not stable in {} of {} directions of load ({}); {}.", sample.name, unstable, sample.directions.size(),
        ranges_of(sample.directions), where
    );
}

std::optional<Figure> stability_in_directions(const std::vector<ProbedSample>& samples) {
    if (samples.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-stress-probes";
    figure.section = "Tests";
    figure.title = "Stability against small loads in all directions";
    for (const ProbedSample& sample : samples) {
        figure.caption += as_sentence(tell_stability(sample)) + " ";
    }
    figure.caption += "0° is lateral stress added, 90° axial stress; a curve that touches the dashed circle can fail "
                      "without more load. Right: a line through the middle would be a sample that answers elastically "
                      "alike to loads put on and taken off.";
    figure.table = probe_table(samples);
    figure.chart = json::parse(chart_text);
    std::vector<std::string> names;
    for (const ProbedSample& sample : samples) {
        names.push_back(sample.name);
    }
    const json tooltip = json::parse(R"json([
        {"field": "sample", "title": "sample"}, {"field": "angle", "title": "direction [°]", "format": ".0f"},
        {"field": "normalized_work", "title": "normalized W₂", "format": ".3f"},
        {"field": "axial_strain", "title": "dε₁ [%]", "format": ".2e"},
        {"field": "lateral_strain", "title": "dε₃ [%]", "format": ".2e"}, {"field": "answer", "title": "the sample"}])json"
    );
    for (json* marks : {&figure.chart["hconcat"][0]["layer"][2], &figure.chart["hconcat"][1]}) {
        (*marks)["encoding"]["tooltip"] = tooltip;
        (*marks)["encoding"]["color"] = {
            {"field", "sample"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", names}, {"range", color::sequence()}}},
            {"legend", {{"orient", "bottom"}, {"columns", 1}, {"labelLimit", 500}}}};
    }
    return figure;
}

} // namespace suffuse::report
