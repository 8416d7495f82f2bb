#include "suffuse/figures/stress_probes.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {
namespace {

using nlohmann::json;

/// As literature draws it: a direction without second-order work lies on the circle of radius 1, with the most that it
/// can have on that of radius 2. Curves are closed.
Table probe_table(const std::vector<study::ProbedState>& states) {
    std::vector<std::string> state;
    std::vector<double> row, angle, work, axial_stress, lateral_stress, axial_strain, lateral_strain, unstable, samples;
    for (const study::ProbedState& each : states) {
        for (std::size_t k = 0; k <= each.directions.size(); ++k) {
            const study::ProbedDirection& d = each.directions[k % each.directions.size()];
            state.push_back(each.name);
            row.push_back(static_cast<double>(k));
            angle.push_back(degrees(d.angle) + (k == each.directions.size() ? 360 : 0));
            work.push_back(d.normalized_work);
            axial_stress.push_back(d.axial_stress / 1e3);
            lateral_stress.push_back(d.lateral_stress / 1e3);
            axial_strain.push_back(100 * d.axial_strain);
            lateral_strain.push_back(100 * d.lateral_strain);
            unstable.push_back(d.unstable);
            samples.push_back(each.samples);
        }
    }
    Table table;
    table.add("state", std::move(state));
    table.add("row", "", std::move(row));
    table.add("angle", "deg", std::move(angle));
    table.add("normalized_work", "-", std::move(work));
    table.add("axial_stress", "kPa", std::move(axial_stress));
    table.add("lateral_stress", "kPa", std::move(lateral_stress));
    table.add("axial_strain", "%", std::move(axial_strain));
    table.add("lateral_strain", "%", std::move(lateral_strain));
    table.add("unstable", "", std::move(unstable));
    table.add("samples", "", std::move(samples));
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

/// "180° to 210°": the directions in which some sample is unstable, as ranges of neighbors.
std::string ranges_of(const std::vector<study::ProbedDirection>& directions) {
    std::string text;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        if (directions[k].unstable == 0) {
            continue;
        }
        std::size_t last = k;
        while (last + 1 < directions.size() && directions[last + 1].unstable > 0) {
            ++last;
        }
        text += text.empty() ? "" : ", ";
        text += fmt::format("{:.0f}°", degrees(directions[k].angle));
        text += last == k ? "" : fmt::format(" to {:.0f}°", degrees(directions[last].angle));
        k = last;
    }
    return text;
}

const study::ProbedDirection& least_stable(const study::ProbedState& state) {
    return *std::min_element(state.directions.begin(), state.directions.end(), [](const auto& a, const auto& b) {
        return a.normalized_work < b.normalized_work;
    });
}

std::string least_work(const study::ProbedState& state) {
    const study::ProbedDirection& least = least_stable(state);
    return fmt::format("{} at {:.0f}°", short_number(least.normalized_work, 2), degrees(least.angle));
}

std::string stability_claim(const std::vector<study::ProbedState>& states) {
    const auto is_unstable = [](const study::ProbedState& state) {
        return std::ranges::any_of(state.directions, [](const auto& direction) { return direction.unstable > 0; });
    };
    const auto unstable = std::ranges::count_if(states, is_unstable);
    if (unstable == 0) {
        return "No direction of load is unstable";
    }
    return states.size() == 1
               ? "Some directions of load are unstable"
               : fmt::format("{} of {} states are unstable in some directions of load", unstable, states.size());
}

} // namespace

std::string describe_stability(const study::ProbedState& state) {
    const auto count = state.directions.size();
    std::string text = state.name + ": ";
    const auto unstable = std::count_if(state.directions.begin(), state.directions.end(), [](const auto& direction) {
        return direction.unstable > 0;
    });
    if (unstable == 0) {
        text += fmt::format("stable in all {} directions of load", count);
    } else {
        const auto most =
            std::max_element(state.directions.begin(), state.directions.end(), [](const auto& a, const auto& b) {
                return a.unstable < b.unstable;
            });
        text +=
            fmt::format("not stable in {} of {} directions of load ({}", unstable, count, ranges_of(state.directions));
        text += state.samples > 1 ? fmt::format("; {} of {} samples)", most->unstable, state.samples) : ")";
    }
    return fmt::format(
        "{}; the least normalized second-order work is {}{}.", text, least_work(state),
        state.samples > 1 ? ", on the mean" : ""
    );
}

std::optional<Figure> stability_in_directions(const std::vector<study::ProbedState>& states) {
    if (states.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-stress-probes";
    figure.section = "Tests";
    figure.title = "Stability against small loads in all directions";
    figure.claim = stability_claim(states);
    std::string least;
    int most = 1;
    for (const study::ProbedState& state : states) {
        least += fmt::format("{}{} {}", least.empty() ? "Least normalized W₂: " : "; ", state.name, least_work(state));
        most = std::max(most, state.samples);
    }
    figure.caption = least +
                     ". 0° is lateral stress added, 90° axial stress; where a curve enters the dashed circle the "
                     "state can fail without more load.";
    figure.caption += most > 1 ? fmt::format(" Means over up to {} samples.", most) : " One sample a curve.";
    figure.table = probe_table(states);
    figure.chart = json::parse(chart_text);
    std::vector<std::string> names;
    names.reserve(states.size());
    for (const study::ProbedState& state : states) {
        names.push_back(state.name);
    }
    const json tooltip = json::parse(R"json([
        {"field": "state", "title": "state"}, {"field": "angle", "title": "direction [°]", "format": ".0f"},
        {"field": "normalized_work", "title": "normalized W₂", "format": ".3f"},
        {"field": "axial_strain", "title": "dε₁ [%]", "format": ".2e"},
        {"field": "lateral_strain", "title": "dε₃ [%]", "format": ".2e"},
        {"field": "unstable", "title": "samples not stable"}, {"field": "samples", "title": "of"}])json");
    for (json* marks : {&figure.chart["hconcat"][0]["layer"][2], &figure.chart["hconcat"][1]}) {
        (*marks)["encoding"]["tooltip"] = tooltip;
        (*marks)["encoding"]["color"] = {
            {"field", "state"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", names}, {"range", color::sequence()}}},
            {"legend", {{"orient", "bottom"}, {"columns", 1}, {"labelLimit", 500}}}};
    }
    return figure;
}

} // namespace suffuse::figures
