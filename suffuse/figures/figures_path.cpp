// Figures 13 and 14: what the removal of each pass did to the skeleton, step by step.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/study/findings.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::figures {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using erosion::PathRow;
using nlohmann::json;

constexpr std::size_t most_named = 4;       ///< passes with labels, colors and words of their own
constexpr std::size_t most_path_rows = 800; ///< drawn; the run's own files hold them all

/// A row of the path, or the state before a removal, which no path holds.
struct DrawnRow {
    PathRow state;
    bool is_before = false;

    [[nodiscard]] std::string_view phase() const { return is_before ? "before" : name_of(state.phase); }
};

/// The path with the state before each removal put in front of it, so that a drawing shows what the removal changed.
std::vector<DrawnRow> with_starts(const ErosionResult& erosion) {
    std::vector<DrawnRow> rows;
    for (const PathRow& row : erosion.path) {
        const bool begins = rows.empty() || rows.back().state.pass != row.pass;
        const auto pass = std::find_if(erosion.passes.begin(), erosion.passes.end(), [&](const PassResult& each) {
            return each.pass == row.pass;
        });
        if (begins && pass != erosion.passes.end()) {
            PathRow start = rows.empty() ? PathRow{} : rows.back().state;
            start.pass = row.pass;
            start.step = row.step;
            start.stress = pass->stress_before;
            start.porosity = pass->porosity_before;
            rows.push_back({start, true});
        }
        rows.push_back({row});
    }
    return rows;
}

/// Rows for drawing: evenly thinned, but every first and last row of a phase stays.
std::vector<DrawnRow> thinned(const std::vector<DrawnRow>& path) {
    if (path.size() <= most_path_rows) {
        return path;
    }
    const std::size_t every = (path.size() + most_path_rows - 1) / most_path_rows;
    const auto same_phase = [](const DrawnRow& a, const DrawnRow& b) {
        return a.state.pass == b.state.pass && a.phase() == b.phase();
    };
    std::vector<DrawnRow> kept;
    for (std::size_t row = 0; row < path.size(); ++row) {
        const bool begins = row == 0 || !same_phase(path[row - 1], path[row]);
        const bool ends = row + 1 == path.size() || !same_phase(path[row], path[row + 1]);
        if (begins || ends || row % every == 0) {
            kept.push_back(path[row]);
        }
    }
    return kept;
}

Table path_table(const std::vector<DrawnRow>& path) {
    std::vector<std::string> pass, phase;
    std::vector<double> row_number, step, since, mean, x, y, z, strain, porosity, resettling, unbalanced, mass;
    PathRow removal;
    for (const DrawnRow& each : path) {
        const PathRow& row = each.state;
        if (!each.is_before && row.phase == erosion::Phase::Removal) {
            removal = row;
        }
        const bool resettles = !each.is_before && row.pass == removal.pass;
        since.push_back(resettles ? static_cast<double>(row.step - removal.step) : missing);
        resettling.push_back(resettles ? row.porosity - removal.porosity : missing);
        row_number.push_back(static_cast<double>(row_number.size()));
        pass.push_back(study::pass_name(row.pass));
        phase.emplace_back(each.phase());
        step.push_back(static_cast<double>(row.step));
        mean.push_back(dem::mean_stress(row.stress));
        x.push_back(row.stress(0, 0) / 1e3);
        y.push_back(row.stress(1, 1) / 1e3);
        z.push_back(row.stress(2, 2) / 1e3);
        strain.push_back(row.volumetric_strain);
        porosity.push_back(row.porosity);
        unbalanced.push_back(row.unbalanced_force);
        mass.push_back(100 * row.eroded_mass);
    }
    Table table;
    table.add("row", "", std::move(row_number));
    table.add("pass", std::move(pass));
    table.add("phase", std::move(phase));
    table.add("step", "", std::move(step));
    table.add_fact("mean_stress", std::move(mean));
    table.add("stress_x", "kPa", std::move(x));
    table.add("stress_y", "kPa", std::move(y));
    table.add("stress_z", "kPa", std::move(z));
    table.add_fact("volumetric_strain", std::move(strain));
    table.add_fact("porosity", std::move(porosity));
    table.add("steps_since_removal", "", std::move(since));
    table.add("porosity_change_since_removal", "-", std::move(resettling));
    table.add_fact("unbalanced_force", std::move(unbalanced));
    table.add("eroded_mass", "%", std::move(mass));
    return table;
}

json only(const study::SomePasses& passes) {
    return {{"filter", {{"field", "pass"}, {"oneOf", study::pass_names(passes)}}}};
}

/// The stretches of the path as shaded bands, with the pass written above its first.
const char* const phase_bands = R"json({
    "transform": [
        {"filter": "datum.phase == 'constant volume' || datum.phase == 'servo'"},
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

/// The strain's axis spans at least a tenth of what finding E5 calls negligible, that of the porosity's change what
/// finding E6 can resolve: rounding is not drawn as if it were a response.
json stress_chart() {
    json chart = json::parse(R"json({
        "vconcat": [
            {"width": 560, "height": 220, "layer": [], "encoding": {"x": {"type": "quantitative",
                "axis": {"title": null, "labels": false, "ticks": false, "tickCount": 6}}}},
            {"width": 560, "height": 160, "layer": [], "encoding": {"x": {"type": "quantitative",
                "title": "step since the start of the erosion [-]", "axis": {"tickCount": 6, "format": ",d"}}}}
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
                                "range": ["#808080", "#3b82b8", "#d55e00", "#17ac5b"]}},
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
            "y": {"field": "volumetric_strain", "type": "quantitative",
                  "axis": {"tickCount": 5}, "scale": {"domain": {"unionWith": [-0.001, 0.001]}}},
            "order": {"field": "row"},
            "tooltip": [{"field": "volumetric_strain"},
                        {"field": "step", "title": "step", "format": ","}, {"field": "phase", "title": "phase"}]
        }
    })json");
    const json bands = json::parse(phase_bands), rules = json::parse(removal_rules);
    chart["vconcat"][0]["layer"] = {bands, rules, json::parse(pass_labels), stresses};
    chart["vconcat"][1]["layer"] = {bands, rules, strain};
    return chart;
}

/// The whole way, and below it the resettling alone, which is small compared with the removal.
const char* const porosity_panels = R"json({
    "vconcat": [
        {"width": 480, "height": 240,
         "encoding": {
            "x": {"field": "eroded_mass", "type": "quantitative", "title": "eroded mass, of the initial mass [%]"},
            "y": {"field": "porosity", "type": "quantitative", "scale": {"zero": false}}
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
                "shape": {"field": "phase", "type": "nominal", "title": null,
                          "scale": {"domain": ["before", "removal", "constant volume", "servo"],
                                    "range": ["diamond", "triangle-up", "square", "circle"]}},
                "tooltip": [{"field": "pass", "title": "pass"}, {"field": "phase", "title": "at the end of"},
                    {"field": "porosity", "title": "porosity n", "format": ".5f"},
                    {"field": "eroded_mass", "title": "eroded mass [%]", "format": ".4g"}]}}
         ]},
        {"width": 480, "height": 120,
         "transform": [{"filter": "isValid(datum.porosity_change_since_removal)"}],
         "mark": {"type": "line"},
         "encoding": {
            "x": {"field": "steps_since_removal", "type": "quantitative", "title": "steps since the removal [-]",
                  "axis": {"format": ",d", "tickCount": 6}},
            "y": {"field": "porosity_change_since_removal", "type": "quantitative", "title": "change Δn [-]",
                  "axis": {"tickCount": 4, "format": "~g"}, "scale": {"domain": {"unionWith": [-1e-5, 1e-5]}}},
            "color": {"field": "pass", "type": "nominal", "title": null},
            "order": {"field": "row"},
            "tooltip": [{"field": "pass", "title": "pass"}, {"field": "phase", "title": "phase"},
                {"field": "steps_since_removal", "title": "steps since the removal", "format": ","},
                {"field": "porosity_change_since_removal", "title": "Δn", "format": ".3g"}]
         }}
    ],
    "spacing": 16
})json";

/// Whether a pass is so short compared with all of them that its name is wider.
bool has_short_pass(const ErosionResult& erosion) {
    constexpr double name_width = 0.12; // of the drawing
    std::int64_t before = 0;
    bool is_short = false;
    for (std::size_t k = 0; k + 1 < erosion.path.size(); ++k) {
        if (erosion.path[k].pass != erosion.path[k + 1].pass) {
            const auto steps = static_cast<double>(erosion.path[k].step - before);
            is_short = is_short || steps < name_width * static_cast<double>(erosion.path.back().step);
            before = erosion.path[k].step;
        }
    }
    return is_short;
}

/// A pass that a drawing of stress and volume shows.
bool changes_skeleton(const PassResult& pass) {
    return !is_noise(100 * erosion::stress_loss(pass).value_or(0)) || !is_noise(100 * pass.volumetric_strain);
}

/// Of the pass that costs most; empty without passes that changed the skeleton.
std::string loss_claim(const ErosionResult& erosion) {
    const PassResult* const worst = erosion::pass_of_largest_loss(erosion);
    if (worst == nullptr || is_noise(100 * *erosion::stress_loss(*worst))) {
        return {};
    }
    if (*erosion::stress_loss(*worst) < 0) {
        return "No pass costs mean stress at constant volume";
    }
    return fmt::format(
        "Pass {} costs {} % of the mean stress at constant volume", worst->pass,
        short_number(100 * *erosion::stress_loss(*worst), 2)
    );
}

std::string porosity_claim(double before, double after) {
    if (std::abs(after - before) <= study::porosity_resolution) {
        return "The porosity does not change";
    }
    return fmt::format("The porosity {} from {:.4f} to {:.4f}", after > before ? "rises" : "falls", before, after);
}

} // namespace

std::optional<Figure> stress_path(const ErosionResult& erosion) {
    if (erosion.path.empty()) {
        return std::nullopt;
    }
    std::string claim;
    const study::SomePasses few = study::few_passes(erosion, most_named);
    for (const PassResult* pass : few) {
        claim += fmt::format(
            "{}pass {}: mean stress {} kPa before, {} at constant volume, {} restored; volumetric strain {} %",
            claim.empty() ? "" : "; ", pass->pass, short_number(dem::mean_stress(pass->stress_before) / 1e3, 4),
            short_number(dem::mean_stress(pass->stress_constant_volume) / 1e3, 4),
            short_number(dem::mean_stress(pass->stress_after) / 1e3, 4),
            percent_beyond_noise(100 * pass->volumetric_strain)
        );
    }
    claim = as_sentence(claim) + study::part_of_passes(few, erosion.passes.size());
    Figure figure;
    figure.id = "fig13";
    figure.section = "Erosion";
    figure.title = "Stress and volumetric strain along the erosion passes";
    figure.claim = loss_claim(erosion);
    figure.caption = claim + (claim.empty() ? "" : ". ") + "Compression and contraction positive.";
    figure.table = path_table(thinned(with_starts(erosion)));
    figure.chart = stress_chart();
    figure.chart["vconcat"][0]["layer"][2]["transform"].push_back(only(few));
    if (has_short_pass(erosion)) { // names side by side would overlap
        figure.chart["vconcat"][0]["layer"][2]["mark"]["dy"] = {
            {"expr", "-3 - 13 * ((toNumber(replace(datum.pass, 'pass ', '')) - 1) % 2)"}};
    }
    if (std::ranges::none_of(erosion.passes, changes_skeleton)) {
        figure.flat = "In no pass did the mean stress or the volume change by a hundredth of a percent: the figure "
                      "would show only rounding.";
    }
    return figure;
}

std::optional<Figure> porosity_path(const ErosionResult& erosion) {
    if (erosion.path.empty()) {
        return std::nullopt;
    }
    const bool settles = std::ranges::any_of(erosion.passes, [](const PassResult& pass) {
        return std::abs(pass.porosity_after_removal - pass.porosity_after) > study::porosity_resolution;
    });
    std::string claim;
    const study::SomePasses few = study::few_passes(erosion, most_named);
    for (const PassResult* pass : few) {
        claim += fmt::format(
            "{}pass {}: n = {:.4f} before, {:.4f} after the removal, {:.4f} resettled", claim.empty() ? "" : "; ",
            pass->pass, pass->porosity_before, pass->porosity_after_removal, pass->porosity_after
        );
    }
    claim = as_sentence(claim) + study::part_of_passes(few, erosion.passes.size());
    Figure figure;
    figure.id = "fig14";
    figure.section = "Erosion";
    figure.title = "Porosity against eroded mass";
    if (!erosion.passes.empty()) {
        figure.claim = porosity_claim(erosion.passes.front().porosity_before, erosion.passes.back().porosity_after);
    }
    figure.caption = claim + (claim.empty() ? "" : ". ") +
                     "A removal moves the sample right and up, resettling straight down" +
                     (settles ? "; the lower panel shows resettling alone."
                              : ". In no pass did resettling change the porosity by more than 0.00001.");
    figure.table = path_table(thinned(with_starts(erosion)));
    figure.chart = json::parse(porosity_panels);
    if (!settles) {
        figure.chart["vconcat"].erase(1);
    }
    if (!erosion.passes.empty()) {
        const json scale = {{"domain", study::pass_names(few)}, {"range", color::sequence()}};
        const auto color = [&](json& panel) {
            panel["encoding"]["color"]["scale"] = scale;
            panel["transform"].push_back(only(few));
        };
        color(figure.chart["vconcat"][0]["layer"][1]);
        if (settles) {
            color(figure.chart["vconcat"][1]);
        }
    }
    return figure;
}

} // namespace suffuse::figures
