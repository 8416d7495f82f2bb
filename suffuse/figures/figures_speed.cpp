// Figures 9 and 10 and the comparison of the detachment rules: what the probes saw.
#include "suffuse/base/quantile.hpp"
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/figures/six_digits.hpp"
#include "suffuse/study/erosion_span.hpp"
#include "suffuse/study/findings.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::figures {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using erosion::ProbeResult;
using nlohmann::json;

constexpr std::size_t most_lines = 200;     ///< grains drawn one by one in a panel, both groups together
constexpr double decades_drawn = 1e9;       ///< below the fastest grain: slower is lost in rounding
constexpr std::size_t most_panels = 4;      ///< of an erosion, a panel a pass
constexpr std::size_t extremes_a_side = 10; ///< slowest and fastest of a group that are always drawn

struct Panel {
    std::string name;  ///< in the table
    std::string title; ///< above the panel
    const ProbeResult* probe;
};

/// "i = 0.05", with the watch where two probes share a gradient.
std::vector<std::string> probe_names(const std::vector<ProbeResult>& probes) {
    std::vector<std::string> names;
    for (const ProbeResult& probe : probes) {
        const auto alike = std::count_if(probes.begin(), probes.end(), [&probe](const ProbeResult& other) {
            return other.gradient == probe.gradient;
        });
        names.push_back(fmt::format("i = {}", probe.gradient));
        if (alike > 1) {
            names.back() += ", watch " + grouped(probe.watch);
        }
        if (std::count(names.begin(), names.end(), names.back()) > 1) {
            names.back() += fmt::format(" #{}", names.size());
        }
    }
    return names;
}

/// Columns, at most `most`, that leave no gap in the last row where there is such a number: axes of empty places
/// confuse.
std::size_t full_rows(std::size_t panels, std::size_t most) {
    for (std::size_t columns = most; 2 * columns > most; --columns) {
        if (panels % columns == 0) {
            return columns;
        }
    }
    return most;
}

struct SpeedColumns {
    std::vector<std::string> panel, group, kind;
    std::vector<double> grain, iteration, speed, slow, fast;

    void row(const std::string& in, const std::string& of, double id, double at, double v, double low, double high) {
        panel.push_back(in);
        group.push_back(of);
        kind.push_back(std::isnan(id) ? "group" : "grain");
        grain.push_back(id);
        iteration.push_back(at);
        speed.push_back(v);
        slow.push_back(low);
        fast.push_back(high);
    }
};

/// At most `room` of the grains, by final speed: both ends whole, evenly spaced ranks between.
std::vector<std::size_t> sampled_grains(const ProbeResult& probe, std::vector<std::size_t> group, std::size_t room) {
    std::sort(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
        const double va = probe.speed[a].back(), vb = probe.speed[b].back();
        return va != vb ? va < vb : probe.id[a] < probe.id[b];
    });
    if (group.size() <= room) {
        return group;
    }
    const std::size_t ends = std::min(extremes_a_side, room / 2), middle = room - 2 * ends;
    std::vector<std::size_t> chosen(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(ends));
    for (std::size_t k = 0; k < middle; ++k) {
        chosen.push_back(group[ends + (2 * k + 1) * (group.size() - 2 * ends) / (2 * middle)]);
    }
    chosen.insert(chosen.end(), group.end() - static_cast<std::ptrdiff_t>(ends), group.end());
    return chosen;
}

void add_group(
    const Panel& panel, const std::string& name, const std::vector<std::size_t>& group, std::size_t room,
    SpeedColumns& out
) {
    const ProbeResult& probe = *panel.probe;
    const double spacing = static_cast<double>(probe.watch) / erosion::probe_samples;
    for (std::size_t sample = 0; sample <= erosion::probe_samples; ++sample) {
        std::vector<double> speeds;
        speeds.reserve(group.size());
        for (const std::size_t g : group) {
            speeds.push_back(probe.speed[g][sample]);
        }
        std::sort(speeds.begin(), speeds.end());
        if (speeds.empty()) {
            continue;
        }
        out.row(
            panel.name, name, missing, static_cast<double>(sample) * spacing, quantile_of_sorted(speeds, 0.5),
            quantile_of_sorted(speeds, 0.1), quantile_of_sorted(speeds, 0.9)
        );
    }
    for (const std::size_t g : sampled_grains(probe, group, room)) {
        for (std::size_t sample = 0; sample <= erosion::probe_samples; ++sample) {
            out.row(
                panel.name, name, probe.id[g], static_cast<double>(sample) * spacing,
                six_digits(probe.speed[g][sample]), missing, missing
            );
        }
    }
}

const char* const detachable_name = "detachable";
const char* const staying_name = "stays";

void add_panel(const Panel& panel, SpeedColumns& out) {
    std::vector<std::size_t> detachable, staying;
    for (std::size_t g = 0; g < panel.probe->id.size(); ++g) {
        (panel.probe->by_velocity[g] != 0 ? detachable : staying).push_back(g);
    }
    // Half of the lines for each group; what one group cannot fill goes to the other.
    const std::size_t few = std::min({detachable.size(), staying.size(), most_lines / 2});
    const std::size_t rest = most_lines - few;
    add_group(panel, staying_name, staying, staying.size() <= detachable.size() ? few : rest, out);
    add_group(panel, detachable_name, detachable, staying.size() <= detachable.size() ? rest : few, out);
}

json speed_chart(const std::vector<Panel>& panels, double lowest, double highest) {
    json chart = json::parse(R"json({
        "columns": 2,
        "facet": {"field": "panel", "type": "nominal", "title": null, "header": {"labelAnchor": "start"}},
        "spec": {
            "width": 300, "height": 200,
            "encoding": {
                "x": {"field": "iteration", "type": "quantitative", "title": "iterations at full fluid force [-]",
                      "axis": {"tickCount": 5}},
                "color": {"field": "group", "type": "nominal", "title": "velocity rule",
                          "legend": {"symbolType": "stroke", "symbolOpacity": 1, "symbolStrokeWidth": 3}}
            },
            "layer": [
                {"transform": [{"filter": "datum.kind == 'grain' && datum.speed > 0"}],
                 "mark": {"type": "line", "strokeWidth": 0.6, "opacity": 0.25, "clip": true},
                 "encoding": {"y": {"field": "speed"}, "detail": {"field": "grain"}}},
                {"transform": [{"filter": "datum.kind == 'group' && datum.speed_90 > 0"}],
                 "mark": {"type": "area", "opacity": 0.25, "clip": true},
                 "encoding": {"y": {"field": "low"}, "y2": {"field": "speed_90"}}},
                {"transform": [{"filter": "datum.kind == 'group' && datum.speed > 0"}],
                 "mark": {"type": "line", "strokeWidth": 2.5, "clip": true, "point": {"size": 80, "opacity": 0}},
                 "encoding": {"y": {"field": "speed"}, "tooltip": [
                     {"field": "group", "title": "group"}, {"field": "iteration", "title": "iteration"},
                     {"field": "speed", "title": "median speed [m/s]", "format": ".3g"},
                     {"field": "speed_10", "title": "10 % quantile [m/s]", "format": ".3g"},
                     {"field": "speed_90", "title": "90 % quantile [m/s]", "format": ".3g"}]}}
            ]
        }
    })json");
    json order = json::array(), titles = json::object();
    for (const Panel& panel : panels) {
        order.push_back(panel.name);
        titles[panel.name] = panel.title;
    }
    chart["facet"]["sort"] = order;
    const bool one_watch = std::all_of(panels.begin(), panels.end(), [&panels](const Panel& panel) {
        return panel.probe->watch == panels.front().probe->watch;
    });
    if (!one_watch) {
        chart["resolve"] = {{"scale", {{"x", "independent"}}}};
    }
    chart["columns"] = full_rows(panels.size(), panels.size() == 3 ? 3 : 2);
    chart["facet"]["header"]["labelExpr"] = titles.dump() + "[datum.value]";
    chart["spec"]["encoding"]["color"]["scale"] = {
        {"domain", {detachable_name, staying_name}}, {"range", {color::detachable, color::staying}}};
    const json axis = {{"labelExpr", power_of_ten_labels()}, {"tickCount", 6}};
    const json y = {
        {"type", "quantitative"},
        {"title", "speed v [m/s]"},
        {"axis", axis},
        {"scale", {{"type", "log"}, {"domain", {lowest, highest}}, {"nice", false}}}};
    for (json& layer : chart["spec"]["layer"]) {
        layer["encoding"]["y"].update(y);
    }
    // A band that reaches down to a speed of zero is drawn down to the axis.
    chart["spec"]["layer"][1]["transform"].push_back(
        {{"calculate", fmt::format("max(datum.speed_10, {})", lowest)}, {"as", "low"}}
    );
    return chart;
}

/// Whole decades around what is drawn.
std::pair<double, double> decades(const std::vector<double>& speeds) {
    double highest = 0, lowest = std::numeric_limits<double>::infinity();
    for (const double v : speeds) {
        if (v > 0) {
            highest = std::max(highest, v);
            lowest = std::min(lowest, v);
        }
    }
    if (!(highest > 0)) {
        return {1e-9, 1};
    }
    lowest = std::max(lowest, highest / decades_drawn);
    const double top = std::pow(10.0, std::ceil(std::log10(highest)));
    return {std::min(std::pow(10.0, std::floor(std::log10(lowest))), top / 10), top};
}

Figure speed_figure(const std::vector<Panel>& panels) {
    SpeedColumns columns;
    for (const Panel& panel : panels) {
        add_panel(panel, columns);
    }
    const auto [lowest, highest] = decades(columns.speed);
    Figure figure;
    figure.section = "Erosion";
    figure.table.add("panel", std::move(columns.panel));
    figure.table.add("group", std::move(columns.group));
    figure.table.add("kind", std::move(columns.kind));
    figure.table.add("grain", "", std::move(columns.grain));
    figure.table.add("iteration", "", std::move(columns.iteration));
    figure.table.add("speed", "m/s", std::move(columns.speed));
    figure.table.add("speed_10", "m/s", std::move(columns.slow));
    figure.table.add("speed_90", "m/s", std::move(columns.fast));
    figure.chart = speed_chart(panels, lowest, highest);
    return figure;
}

std::string share_detached(const ProbeResult& probe) {
    const study::Detached detached = study::count_detached(probe);
    return fmt::format("{} of {} fines detachable", grouped(detached.yes), grouped(detached.yes + detached.no));
}

const char* const how_drawn =
    " Bands: 10 to 90 % of each group, thick line: median, thin lines: at most 200 grains, the "
    "slowest and fastest among them. A band down to the axis: a tenth of the group or more is slower than any speed "
    "shown.";

/// "12 % of the fines are detachable at i = 0.1, 98 % at i = 10": of the first and the last panel.
/// @param in "at " a gradient, or "in " a pass
std::string detached_claim(const std::vector<Panel>& panels, const char* in) {
    const auto share = [](const Panel& panel) {
        const study::Detached detached = study::count_detached(*panel.probe);
        return 100.0 * static_cast<double>(detached.yes) / static_cast<double>(detached.yes + detached.no);
    };
    const Panel& first = panels.front();
    const Panel& last = panels.back();
    std::string claim =
        fmt::format("{} % of the fines are detachable {}{}", short_number(share(first), 2), in, first.name);
    return panels.size() < 2 ? claim : claim + fmt::format(", {} % {}{}", short_number(share(last), 2), in, last.name);
}

} // namespace

std::optional<Figure> speed_by_gradient(const std::vector<ProbeResult>& probes) {
    std::vector<Panel> panels;
    std::string counts;
    const std::vector<std::string> names = probe_names(probes);
    for (std::size_t p = 0; p < probes.size(); ++p) {
        if (probes[p].id.empty()) {
            continue;
        }
        panels.push_back({names[p], names[p] + ": " + share_detached(probes[p]), &probes[p]});
        counts += fmt::format(
            "{}{} at {}", counts.empty() ? "" : ", ", grouped(study::count_detached(probes[p]).yes), names[p]
        );
    }
    if (panels.empty()) {
        return std::nullopt;
    }
    Figure figure = speed_figure(panels);
    figure.id = "fig09";
    figure.title = "Speed of the fines under the fluid force, by hydraulic gradient";
    figure.claim = detached_claim(panels, "at ");
    figure.caption = "Detachable fines by the velocity rule: " + counts + "." + how_drawn;
    return figure;
}

std::optional<Figure> speed_by_pass(const ErosionResult& erosion) {
    std::vector<Panel> panels;
    std::string counts;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    const study::SomePasses few = study::few_passes(erosion, most_panels);
    for (const PassResult* pass : few) {
        least = std::min(least, pass->probe.gradient), most = std::max(most, pass->probe.gradient);
    }
    for (const PassResult* pass : few) {
        if (pass->probe.id.empty()) {
            continue;
        }
        const std::string name = study::pass_name(pass->pass);
        const std::string at = least == most ? "" : fmt::format(", i = {:g}", pass->probe.gradient);
        panels.push_back({name, name + at + ": " + share_detached(pass->probe), &pass->probe});
        const study::Detached detached = study::count_detached(pass->probe);
        counts += fmt::format("{}{} in pass {}", counts.empty() ? "" : ", ", grouped(detached.yes), pass->pass);
    }
    if (panels.empty()) {
        return std::nullopt;
    }
    Figure figure = speed_figure(panels);
    figure.id = "fig10";
    figure.title = "Speed of the fines in each erosion pass, i = " + study::range_in_words(least, most);
    figure.claim = detached_claim(panels, "in ");
    figure.caption = "Detachable fines by the velocity rule: " + counts +
                     study::part_of_passes(few, erosion.passes.size()) + "." + how_drawn;
    return figure;
}

std::optional<Figure>
rules_compared(const std::vector<ProbeResult>& probes, const std::vector<NamedErosion>& erosions) {
    std::vector<std::string> probe_name, velocity, displacement, verdicts, order;
    std::vector<double> grains, share;
    std::int64_t all = 0, agreed = 0;
    const auto add = [&](const std::string& name, const ProbeResult& probe) {
        const auto& n = probe.agreement;
        const std::int64_t total = n[0][0] + n[0][1] + n[1][0] + n[1][1];
        if (total == 0) {
            return;
        }
        order.push_back(name);
        all += total;
        agreed += n[0][0] + n[1][1];
        for (const std::size_t v : {1U, 0U}) {
            for (const std::size_t d : {1U, 0U}) {
                probe_name.push_back(name);
                velocity.emplace_back(v == 1 ? "detachable" : "stays");
                displacement.emplace_back(d == 1 ? "detachable" : "stays");
                verdicts.emplace_back(v == d ? "agree" : "differ");
                grains.push_back(static_cast<double>(n[v][d]));
                share.push_back(100.0 * static_cast<double>(n[v][d]) / static_cast<double>(total));
            }
        }
    };
    const std::vector<std::string> names = probe_names(probes);
    for (std::size_t p = 0; p < probes.size(); ++p) {
        add("probe, " + names[p], probes[p]);
    }
    for (const auto& [name, erosion] : erosions) {
        for (const PassResult* pass : study::few_passes(*erosion, most_panels)) {
            add(fmt::format("{}{}pass {}, i = {}", name, name.empty() ? "" : ", ", pass->pass, pass->probe.gradient),
                pass->probe);
        }
    }
    if (order.empty()) {
        return std::nullopt;
    }

    Figure figure;
    figure.id = "own-rules";
    figure.section = "Erosion";
    figure.title = "Velocity rule against displacement rule, on the same probes";
    figure.caption = fmt::format(
        "The two rules agree on {} of {} verdicts ({} %); the diagonal from top left holds the agreement.",
        grouped(agreed), grouped(all), short_number(100.0 * static_cast<double>(agreed) / static_cast<double>(all), 4)
    );
    figure.claim = agreed == all
                       ? "The two rules agree on every verdict"
                       : fmt::format("The two rules differ on {} of {} verdicts", grouped(all - agreed), grouped(all));
    figure.table.add("probe", std::move(probe_name));
    figure.table.add("velocity_rule", std::move(velocity));
    figure.table.add("displacement_rule", std::move(displacement));
    figure.table.add("rules", std::move(verdicts));
    figure.table.add("grains", "", std::move(grains));
    figure.table.add("share", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "columns": 4,
        "facet": {"field": "probe", "type": "nominal", "title": null},
        "spec": {
            "width": 130, "height": 110,
            "encoding": {
                "x": {"field": "displacement_rule", "type": "nominal", "title": "displacement rule [-]",
                      "sort": ["detachable", "stays"], "axis": {"labelAngle": 0, "domain": false, "ticks": false}},
                "y": {"field": "velocity_rule", "type": "nominal", "title": "velocity rule [-]",
                      "sort": ["detachable", "stays"], "axis": {"domain": false, "ticks": false}}
            },
            "layer": [
                {"mark": {"type": "rect", "stroke": "#999999", "strokeWidth": 0.5},
                 "encoding": {
                    "fill": {"field": "rules", "type": "nominal", "title": "the rules", "scale":
                             {"domain": ["agree", "differ"], "range": ["#3b82b8", "#d55e00"]},
                             "legend": {"symbolOpacity": 0.6, "symbolStrokeWidth": 0}},
                    "fillOpacity": {"field": "share", "type": "quantitative", "legend": null,
                                    "scale": {"domain": [0, 100], "range": [0.06, 0.6]}},
                    "tooltip": [{"field": "grains", "title": "grains", "format": ","},
                                {"field": "share", "title": "share of the fines [%]", "format": ".3g"}]}},
                {"mark": {"type": "text", "fontSize": 13, "color": "#111111"},
                 "encoding": {"text": {"field": "grains", "type": "quantitative", "format": ","}}}
            ]
        }
    })json");
    figure.chart["facet"]["sort"] = order;
    figure.chart["columns"] = full_rows(order.size(), 4);
    return figure;
}

} // namespace suffuse::figures
