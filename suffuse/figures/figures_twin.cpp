// Each fine grain under the water against its own twin without: noise lies on the diagonal, the water's doing above it.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::figures {
namespace {

using erosion::PassResult;
using erosion::ProbeResult;
using nlohmann::json;

constexpr std::size_t most_twins = 500; // drawn in a panel: those that leave first
constexpr std::size_t most_twin_panels = 4;
constexpr double twin_decades_drawn = 1e9; // below the fastest grain: slower is lost in rounding

const char* const accepted_name = "detachable, beyond its twin";
const char* const refused_name = "detachable, as its twin";
const char* const resting_name = "stays";

const char* twin_group(const ProbeResult& probe, std::size_t g) {
    return probe.by_velocity[g] == 0 ? resting_name : probe.by_displacement[g] != 0 ? accepted_name : refused_name;
}

/// Of each group evenly spaced rows, as many as its share of the room, but no group is lost.
std::vector<std::size_t> some_grains(const ProbeResult& probe) {
    std::vector<std::size_t> some;
    for (const char* group : {refused_name, accepted_name, resting_name}) {
        std::vector<std::size_t> all;
        for (std::size_t g = 0; g < probe.id.size(); ++g) {
            if (twin_group(probe, g) == group) {
                all.push_back(g);
            }
        }
        const std::size_t room = std::min(all.size(), most_twins / 3);
        for (std::size_t k = 0; k < room; ++k) {
            some.push_back(all[k * all.size() / room]);
        }
    }
    return some;
}

struct TwinColumns {
    std::vector<std::string> panel, group;
    std::vector<double> grain, twin, speed;
};

void add_twins(const std::string& panel, const ProbeResult& probe, TwinColumns& out) {
    for (const std::size_t g : some_grains(probe)) {
        out.panel.push_back(panel);
        out.group.emplace_back(twin_group(probe, g));
        out.grain.push_back(probe.id[g]);
        out.twin.push_back(probe.twin_speed[g]);
        out.speed.push_back(probe.speed[g].back());
    }
}

json twin_chart(const std::vector<std::string>& panels, double lowest, double highest) {
    json chart = json::parse(R"json({
        "columns": 2,
        "facet": {"field": "panel", "type": "nominal", "title": null, "header": {"labelAnchor": "start"}},
        "spec": {
            "width": 260, "height": 260,
            "encoding": {
                "x": {"field": "twin_drawn", "type": "quantitative", "title": "speed of the twin without water [m/s]"},
                "y": {"field": "speed_drawn", "type": "quantitative", "title": "speed with water [m/s]"}
            },
            "layer": [
                {"mark": {"type": "point", "filled": true, "size": 18, "opacity": 0.6, "clip": true},
                 "encoding": {
                    "color": {"field": "group", "type": "nominal", "title": null,
                              "legend": {"symbolOpacity": 1, "orient": "bottom"}},
                    "shape": {"field": "group", "type": "nominal", "title": null,
                              "legend": {"symbolOpacity": 1, "orient": "bottom"}},
                    "tooltip": [{"field": "grain", "title": "grain"}, {"field": "group", "title": "group"},
                                {"field": "speed", "title": "with water [m/s]", "format": ".3g"},
                                {"field": "twin_speed", "title": "twin [m/s]", "format": ".3g"}]}}
            ]
        }
    })json");
    const json scale = {{"type", "log"}, {"domain", {lowest, highest}}, {"nice", false}};
    const json axis = {{"labelExpr", power_of_ten_labels()}, {"tickCount", 6}};
    for (const char* field : {"x", "y"}) {
        chart["spec"]["encoding"][field]["scale"] = scale;
        chart["spec"]["encoding"][field]["axis"] = axis;
    }
    // A grain at rest is drawn on the axis: a logarithm has no place for it.
    chart["spec"]["transform"] = {
        {{"calculate", fmt::format("max(datum.twin_speed, {})", lowest)}, {"as", "twin_drawn"}},
        {{"calculate", fmt::format("max(datum.speed, {})", lowest)}, {"as", "speed_drawn"}}};
    json& points = chart["spec"]["layer"][0];
    points["encoding"]["color"]["scale"] = {
        {"domain", {accepted_name, refused_name, resting_name}},
        {"range", {color::detachable, color::coarse, color::staying}}};
    points["encoding"]["shape"]["scale"] = {
        {"domain", {accepted_name, refused_name, resting_name}}, {"range", {"circle", "cross", "square"}}};
    // The diagonal of equal speeds, from the same rows: the two axes are alike.
    chart["spec"]["layer"].push_back(
        {{"mark", {{"type", "line"}, {"color", color::quiet}, {"strokeDash", {4, 3}}}},
         {"transform", {{{"calculate", "datum.twin_drawn"}, {"as", "same"}}}},
         {"encoding",
          {{"x", {{"field", "twin_drawn"}, {"type", "quantitative"}}},
           {"y", {{"field", "same"}, {"type", "quantitative"}}}}}}
    );
    chart["facet"]["sort"] = panels;
    return chart;
}

/// Whole decades around what is drawn.
std::pair<double, double> twin_decades(const TwinColumns& columns) {
    double highest = 0, lowest = std::numeric_limits<double>::infinity();
    for (const std::vector<double>* speeds : {&columns.twin, &columns.speed}) {
        for (const double v : *speeds) {
            highest = std::max(highest, v);
            lowest = v > 0 ? std::min(lowest, v) : lowest;
        }
    }
    if (!(highest > 0)) {
        return {1e-9, 1};
    }
    lowest = std::max(lowest, highest / twin_decades_drawn);
    const double top = std::pow(10.0, std::ceil(std::log10(highest)));
    return {std::min(std::pow(10.0, std::floor(std::log10(lowest))), top / 10), top};
}

} // namespace

std::optional<Figure> compared_with_twin(const erosion::ErosionResult& erosion) {
    TwinColumns columns;
    std::vector<std::string> panels, reported;
    std::int64_t beyond = 0, detachable = 0;
    for (const PassResult* pass : study::few_passes(erosion, most_twin_panels)) {
        const ProbeResult& probe = pass->probe;
        if (probe.twin_speed.size() != probe.id.size() || probe.id.empty()) {
            continue;
        }
        panels.push_back(study::pass_name(pass->pass));
        add_twins(panels.back(), probe, columns);
        const auto [refused, accepted] = probe.agreement[1];
        beyond += accepted;
        detachable += refused + accepted;
        reported.push_back(fmt::format(
            "in {} {} of {} detachable fines go beyond their twin, and the median of all fines is {} times that of the "
            "twin",
            panels.back(), grouped(accepted), grouped(refused + accepted), short_number(probe.signal_over_twin)
        ));
    }
    if (panels.empty()) {
        return std::nullopt;
    }
    const auto [lowest, highest] = twin_decades(columns);
    Figure figure;
    figure.id = "own-twin";
    figure.section = "Erosion";
    figure.title = "Each fine grain with water, and its twin without";
    figure.claim = detachable > 0
                       ? fmt::format(
                             "{} % of the detachable fines go beyond their twin",
                             short_number(100.0 * static_cast<double>(beyond) / static_cast<double>(detachable), 2)
                         )
                       : "No fine grain is detachable";
    figure.caption = fmt::format(
        "{}. On the dashed diagonal a grain moves as it would without water: the residual unbalanced forces move it. "
        "At most {} grains of a group are drawn; one at rest is drawn on the axis.",
        as_sentence(fmt::format("{}", fmt::join(reported, "; "))), most_twins / 3
    );
    figure.table.add("panel", std::move(columns.panel));
    figure.table.add("group", std::move(columns.group));
    figure.table.add("grain", "", std::move(columns.grain));
    figure.table.add("twin_speed", "m/s", std::move(columns.twin));
    figure.table.add("speed", "m/s", std::move(columns.speed));
    figure.chart = twin_chart(panels, lowest, highest);
    return figure;
}

} // namespace suffuse::figures
