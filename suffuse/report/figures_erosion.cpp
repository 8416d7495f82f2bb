// Figures 11 to 14: what each pass took, and what it did to the skeleton.
#include "suffuse/report/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::report {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using erosion::PathRow;
using nlohmann::json;

constexpr std::size_t most_path_rows = 800; ///< drawn; the run's own files hold them all

std::string pass_name(int pass) {
    return fmt::format("pass {}", pass);
}

double mean_stress(const Mat3& stress) {
    return (stress(0, 0) + stress(1, 1) + stress(2, 2)) / 3;
}

/// Rows for drawing: evenly thinned, but every first and last row of a phase stays.
std::vector<PathRow> thinned(const std::vector<PathRow>& path) {
    if (path.size() <= most_path_rows) {
        return path;
    }
    const std::size_t every = (path.size() + most_path_rows - 1) / most_path_rows;
    const auto same_phase = [](const PathRow& a, const PathRow& b) { return a.pass == b.pass && a.phase == b.phase; };
    std::vector<PathRow> kept;
    for (std::size_t row = 0; row < path.size(); ++row) {
        const bool begins = row == 0 || !same_phase(path[row - 1], path[row]);
        const bool ends = row + 1 == path.size() || !same_phase(path[row], path[row + 1]);
        if (begins || ends || row % every == 0) {
            kept.push_back(path[row]);
        }
    }
    return kept;
}

Table path_table(const std::vector<PathRow>& path) {
    std::vector<std::string> pass, phase;
    std::vector<double> row_number, step, mean, x, y, z, strain, porosity, unbalanced, mass;
    for (const PathRow& row : path) {
        row_number.push_back(static_cast<double>(row_number.size()));
        pass.push_back(pass_name(row.pass));
        phase.push_back(row.phase);
        step.push_back(static_cast<double>(row.step));
        mean.push_back(mean_stress(row.stress) / 1e3);
        x.push_back(row.stress(0, 0) / 1e3);
        y.push_back(row.stress(1, 1) / 1e3);
        z.push_back(row.stress(2, 2) / 1e3);
        strain.push_back(100 * row.volumetric_strain);
        porosity.push_back(row.porosity);
        unbalanced.push_back(row.unbalanced_force);
        mass.push_back(100 * row.eroded_mass);
    }
    Table table;
    table.add("row", "", std::move(row_number));
    table.add("pass", std::move(pass));
    table.add("phase", std::move(phase));
    table.add("step", "", std::move(step));
    table.add("mean_stress", "kPa", std::move(mean));
    table.add("stress_x", "kPa", std::move(x));
    table.add("stress_y", "kPa", std::move(y));
    table.add("stress_z", "kPa", std::move(z));
    table.add("volumetric_strain", "%", std::move(strain));
    table.add("porosity", "-", std::move(porosity));
    table.add("unbalanced_force", "-", std::move(unbalanced));
    table.add("eroded_mass", "%", std::move(mass));
    return table;
}

std::vector<std::string> pass_names(const ErosionResult& erosion) {
    std::vector<std::string> names;
    for (const PassResult& pass : erosion.passes) {
        names.push_back(pass_name(pass.pass));
    }
    return names;
}

/// The stretches of the path as shaded bands, with the pass written above its first.
const char* const phase_bands = R"json({
    "transform": [
        {"filter": "datum.phase != 'removal'"},
        {"aggregate": [{"op": "min", "field": "step", "as": "from"}, {"op": "max", "field": "step", "as": "to"}],
         "groupby": ["pass", "phase"]}],
    "mark": {"type": "rect", "opacity": 0.16},
    "encoding": {
        "x": {"field": "from", "type": "quantitative"}, "x2": {"field": "to"},
        "fill": {"field": "phase", "type": "nominal", "title": "phase",
                 "scale": {"domain": ["constant volume", "servo"], "range": ["#b5852f", "#3b82b8"]},
                 "legend": {"symbolOpacity": 0.4, "symbolStrokeWidth": 0}},
        "tooltip": [{"field": "pass", "title": "pass"}, {"field": "phase", "title": "phase"},
                    {"field": "from", "title": "from step", "format": ","}, {"field": "to", "title": "to step", "format": ","}]
    }
})json";

/// Where each pass removes its grains.
const char* const removal_rules = R"json({
    "transform": [
        {"aggregate": [{"op": "min", "field": "step", "as": "from"}], "groupby": ["pass"]}],
    "mark": {"type": "rule", "color": "#808080", "strokeDash": [4, 3]},
    "encoding": {"x": {"field": "from", "type": "quantitative"}}
})json";

const char* const pass_labels = R"json({
    "transform": [
        {"aggregate": [{"op": "min", "field": "step", "as": "from"}], "groupby": ["pass"]}],
    "mark": {"type": "text", "align": "left", "baseline": "bottom", "dx": 2, "dy": -3, "color": "#808080"},
    "encoding": {"x": {"field": "from", "type": "quantitative"}, "y": {"value": 0},
                 "text": {"field": "pass", "type": "nominal"}}
})json";

json stress_chart() {
    json chart = json::parse(R"json({
        "vconcat": [
            {"width": 560, "height": 220, "layer": [], "encoding": {"x": {"type": "quantitative",
                "axis": {"title": null, "labels": false, "ticks": false}}}},
            {"width": 560, "height": 160, "layer": [], "encoding": {"x": {"type": "quantitative",
                "title": "step since the start of the erosion [-]", "axis": {"tickCount": 6, "format": "~s"}}}}
        ],
        "spacing": 8,
        "resolve": {"scale": {"x": "shared"}}
    })json");
    json stresses = json::parse(R"json({
        "transform": [
            {"calculate": "datum.mean_stress", "as": "mean p"}, {"calculate": "datum.stress_x", "as": "σx"},
            {"calculate": "datum.stress_y", "as": "σy"}, {"calculate": "datum.stress_z", "as": "σz"},
            {"fold": ["σx", "σy", "σz", "mean p"], "as": ["component", "stress"]}],
        "mark": {"type": "line"},
        "encoding": {
            "x": {"field": "step"},
            "y": {"field": "stress", "type": "quantitative", "title": "stress σ, p [kPa]", "scale": {"zero": true}},
            "color": {"field": "component", "type": "nominal", "title": "stress",
                      "scale": {"domain": ["mean p", "σx", "σy", "σz"],
                                "range": ["#808080", "#3b82b8", "#d55e00", "#2a9d74"]}},
            "strokeDash": {"field": "component", "type": "nominal",
                      "scale": {"domain": ["mean p", "σx", "σy", "σz"], "range": [[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]}},
            "order": {"field": "row"},
            "tooltip": [{"field": "component", "title": "stress"}, {"field": "stress", "title": "value [kPa]", "format": ".4g"},
                        {"field": "step", "title": "step", "format": ","}, {"field": "phase", "title": "phase"}]
        }
    })json");
    json strain = json::parse(R"json({
        "mark": {"type": "line", "color": "#c8322b"},
        "encoding": {
            "x": {"field": "step"},
            "y": {"field": "volumetric_strain", "type": "quantitative", "title": "volumetric strain εᵥ [%]"},
            "order": {"field": "row"},
            "tooltip": [{"field": "volumetric_strain", "title": "εᵥ [%]", "format": ".3g"},
                        {"field": "step", "title": "step", "format": ","}, {"field": "phase", "title": "phase"}]
        }
    })json");
    const json bands = json::parse(phase_bands), rules = json::parse(removal_rules);
    chart["vconcat"][0]["layer"] = {bands, rules, json::parse(pass_labels), stresses};
    chart["vconcat"][1]["layer"] = {bands, rules, strain};
    return chart;
}

} // namespace

std::optional<Figure> eroded_mass(const ErosionResult& erosion) {
    if (erosion.passes.empty()) {
        return std::nullopt;
    }
    std::vector<double> removed, share, of_initial;
    std::string claim;
    double total = 0;
    for (const PassResult& pass : erosion.passes) {
        removed.push_back(static_cast<double>(pass.removed));
        share.push_back(pass.eroded_mass_percent);
        of_initial.push_back(pass.eroded_mass_percent_of_initial);
        total += pass.eroded_mass_percent_of_initial;
        claim += fmt::format("{}{:.3g} % in pass {}", claim.empty() ? "" : ", ", pass.eroded_mass_percent, pass.pass);
    }
    Figure figure;
    figure.id = "fig11";
    figure.section = "Erosion";
    figure.title = "Eroded mass of each pass";
    figure.caption = fmt::format("Of the mass before the pass: {}; {:.3g} % of the initial mass in all.", claim, total);
    figure.table.add("pass", pass_names(erosion));
    figure.table.add("removed_grains", "", std::move(removed));
    figure.table.add("eroded_mass", "%", std::move(share));
    figure.table.add("eroded_mass_of_initial", "%", std::move(of_initial));
    figure.chart = json::parse(R"json({
        "width": 360, "height": 240,
        "encoding": {
            "x": {"field": "pass", "type": "nominal", "title": "erosion pass [-]", "sort": null, "axis": {"labelAngle": 0}},
            "y": {"field": "eroded_mass", "type": "quantitative", "title": "eroded mass, of the mass before the pass [%]"}
        },
        "layer": [
            {"mark": {"type": "bar", "width": {"band": 0.5}, "color": "#c8322b"},
             "encoding": {"tooltip": [{"field": "pass", "title": "pass"},
                {"field": "eroded_mass", "title": "of the mass before [%]", "format": ".4g"},
                {"field": "eroded_mass_of_initial", "title": "of the initial mass [%]", "format": ".4g"},
                {"field": "removed_grains", "title": "grains", "format": ","}]}},
            {"mark": {"type": "text", "dy": -8, "fontSize": 12, "color": "#333333"},
             "encoding": {"text": {"field": "eroded_mass", "type": "quantitative", "format": ".3g"}}}
        ]
    })json");
    return figure;
}

std::optional<Figure> eroded_coordination(const ErosionResult& erosion) {
    std::vector<std::string> name, order;
    std::vector<double> contacts, grains, share;
    std::string claim;
    int most = 0;
    for (const PassResult& pass : erosion.passes) {
        for (const auto& [coordination, count] : pass.coordination_histogram) {
            if (count > 0) {
                most = std::max(most, coordination);
            }
        }
    }
    for (const PassResult& pass : erosion.passes) {
        std::int64_t all = 0, active = 0;
        for (const auto& [coordination, count] : pass.coordination_histogram) {
            all += count;
            if (coordination >= 2) {
                active += count;
            }
        }
        if (all == 0) {
            continue;
        }
        order.push_back(pass_name(pass.pass));
        claim += fmt::format(
            "{}pass {}: {} of {} removed grains had at least two contacts ({:.3g} %)", claim.empty() ? "" : "; ",
            pass.pass, grouped(active), grouped(all), 100.0 * static_cast<double>(active) / static_cast<double>(all)
        );
        for (int coordination = 0; coordination <= most; ++coordination) {
            const auto found = pass.coordination_histogram.find(coordination);
            const std::int64_t count = found == pass.coordination_histogram.end() ? 0 : found->second;
            name.push_back(pass_name(pass.pass));
            contacts.push_back(coordination);
            grains.push_back(static_cast<double>(count));
            share.push_back(100.0 * static_cast<double>(count) / static_cast<double>(all));
        }
    }
    if (order.empty()) {
        return std::nullopt;
    }
    claim[0] = 'P';
    Figure figure;
    figure.id = "fig12";
    figure.section = "Erosion";
    figure.title = "Contacts that the removed grains had";
    figure.caption = claim + ".";
    figure.table.add("pass", std::move(name));
    figure.table.add("coordination", "", std::move(contacts));
    figure.table.add("grains", "", std::move(grains));
    figure.table.add("share", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 480, "height": 240,
        "mark": {"type": "bar"},
        "encoding": {
            "x": {"field": "coordination", "type": "ordinal", "title": "contacts of the grain, coordination number Z [-]",
                  "axis": {"labelAngle": 0, "format": "d"}},
            "xOffset": {"field": "pass", "type": "nominal"},
            "y": {"field": "share", "type": "quantitative", "title": "share of the grains removed in the pass [%]"},
            "color": {"field": "pass", "type": "nominal", "title": null},
            "tooltip": [{"field": "pass", "title": "pass"}, {"field": "coordination", "title": "contacts"},
                        {"field": "grains", "title": "grains", "format": ","},
                        {"field": "share", "title": "share [%]", "format": ".3g"}]
        }
    })json");
    figure.chart["encoding"]["color"]["scale"] = {{"domain", order}, {"range", color::sequence()}};
    figure.chart["encoding"]["xOffset"]["sort"] = order;
    return figure;
}

std::optional<Figure> stress_path(const ErosionResult& erosion) {
    if (erosion.path.empty()) {
        return std::nullopt;
    }
    std::string claim;
    for (const PassResult& pass : erosion.passes) {
        claim += fmt::format(
            "{}ass {}: mean stress {:.4g} kPa before, {:.4g} at constant volume, {:.4g} restored; volumetric strain "
            "{:.3g} %",
            claim.empty() ? "P" : "; p", pass.pass, mean_stress(pass.stress_before) / 1e3,
            mean_stress(pass.stress_constant_volume) / 1e3, mean_stress(pass.stress_after) / 1e3,
            100 * pass.volumetric_strain
        );
    }
    Figure figure;
    figure.id = "fig13";
    figure.section = "Erosion";
    figure.title = "Stress and volumetric strain along the erosion passes";
    figure.caption = claim + (claim.empty() ? "" : ". ") + "Compression and contraction positive.";
    figure.table = path_table(thinned(erosion.path));
    figure.chart = stress_chart();
    return figure;
}

std::optional<Figure> porosity_path(const ErosionResult& erosion) {
    if (erosion.path.empty()) {
        return std::nullopt;
    }
    std::string claim;
    for (const PassResult& pass : erosion.passes) {
        claim += fmt::format(
            "{}ass {}: n = {:.4f} before, {:.4f} after the removal, {:.4f} resettled", claim.empty() ? "P" : "; p",
            pass.pass, pass.porosity_before, pass.porosity_after_removal, pass.porosity_after
        );
    }
    Figure figure;
    figure.id = "fig14";
    figure.section = "Erosion";
    figure.title = "Porosity against eroded mass";
    figure.caption = claim + (claim.empty() ? "" : ". ") +
                     "Each removal moves the sample right and up, each resettling straight down.";
    figure.table = path_table(thinned(erosion.path));
    figure.chart = json::parse(R"json({
        "width": 480, "height": 280,
        "encoding": {
            "x": {"field": "eroded_mass", "type": "quantitative", "title": "eroded mass, of the initial mass [%]"},
            "y": {"field": "porosity", "type": "quantitative", "title": "porosity n [-]", "scale": {"zero": false}}
        },
        "layer": [
            {"mark": {"type": "line", "color": "#808080", "strokeWidth": 1.5}, "encoding": {"order": {"field": "row"}}},
            {"transform": [
                {"window": [{"op": "last_value", "field": "row", "as": "end"}], "frame": [null, null],
                 "groupby": ["pass", "phase"], "sort": [{"field": "row"}]},
                {"filter": "datum.row == datum.end"}],
             "mark": {"type": "point", "filled": true, "size": 80, "opacity": 1},
             "encoding": {
                "color": {"field": "pass", "type": "nominal", "title": null},
                "shape": {"field": "phase", "type": "nominal", "title": "at the end of",
                          "scale": {"domain": ["removal", "constant volume", "servo"], "range": ["triangle-up", "square", "circle"]}},
                "tooltip": [{"field": "pass", "title": "pass"}, {"field": "phase", "title": "at the end of"},
                    {"field": "porosity", "title": "porosity n", "format": ".5f"},
                    {"field": "eroded_mass", "title": "eroded mass [%]", "format": ".4g"}]}}
        ]
    })json");
    figure.chart["layer"][1]["encoding"]["color"]["scale"] = {
        {"domain", pass_names(erosion)}, {"range", color::sequence()}};
    if (erosion.passes.empty()) {
        figure.chart["layer"][1]["encoding"]["color"].erase("scale");
    }
    return figure;
}

} // namespace suffuse::report
