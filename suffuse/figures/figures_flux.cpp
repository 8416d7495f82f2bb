#include "suffuse/figures/figures_flux.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/figures/size_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using flow::ThroatFlux;
using nlohmann::json;

json names_of(const std::vector<FluxState>& states) {
    json names = json::array();
    for (const FluxState& state : states) {
        names.push_back(state.name);
    }
    return names;
}

/// The same colors and dashes for the states in all panels.
void color_states(json& encoding, const json& names) {
    encoding["color"] = {
        {"field", "state"},
        {"type", "nominal"},
        {"title", nullptr},
        {"legend", {{"symbolType", "stroke"}, {"symbolOpacity", 1}}},
        {"scale", {{"domain", names}, {"range", color::sequence()}}}};
    encoding["strokeDash"] = {
        {"field", "state"},
        {"type", "nominal"},
        {"title", nullptr},
        {"scale", {{"domain", names}, {"range", color::dashes()}}}};
}

/// Exponent of the power of the size with which the median flux grows, by least squares of the logarithms over the
/// classes; not a number where they are too few.
double growth(const ThroatFlux& flux) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t k = 0; k < flux.diameter.size(); ++k) {
        if (flux.flux_50[k] > 0) {
            const double a = std::log(flux.diameter[k]), b = std::log(flux.flux_50[k]);
            n += 1, x += a, y += b, xx += a * a, xy += a * b;
        }
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

/// "2.9 to 3.1", or "3" where all round alike.
std::string range_of(const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    const std::string from = short_number(least, 2), to = short_number(most, 2);
    return from == to ? from : from + " to " + to;
}

} // namespace

std::optional<Figure> flux_by_size(const std::vector<FluxState>& states) {
    std::vector<std::string> state;
    std::vector<double> diameter, low, median, high, exponents;
    std::string claim;
    for (const FluxState& each : states) {
        const ThroatFlux& flux = each.flux;
        for (std::size_t k = 0; k < flux.diameter.size(); ++k) {
            state.push_back(each.name);
            diameter.push_back(1e3 * flux.diameter[k]);
            low.push_back(flux.flux_10[k]);
            median.push_back(flux.flux_50[k]);
            high.push_back(flux.flux_90[k]);
        }
        if (const double exponent = growth(flux); std::isfinite(exponent)) {
            exponents.push_back(exponent);
            claim += fmt::format(
                "{}{}: the median flux grows as the power {} of the size, the mean flux is {} m³/s at i = 1",
                claim.empty() ? "" : "; ", each.name, short_number(exponent, 2), short_number(flux.mean)
            );
        }
    }
    if (state.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-throat-flux";
    figure.section = "Water";
    figure.title = "Flux through a throat against its size";
    if (!exponents.empty()) {
        figure.claim = fmt::format("The flux grows as the power {} of a throat's size", range_of(exponents));
    }
    figure.caption = as_sentence(claim) + (claim.empty() ? "" : ". ") +
                     "Lines: medians of classes of equally many throats; bands: their middle 80 %.";
    figure.table.add("state", std::move(state));
    figure.table.add("diameter", "mm", std::move(diameter));
    figure.table.add("flux_over_mean", "-", std::move(median));
    figure.table.add("flux_10", "-", std::move(low));
    figure.table.add("flux_90", "-", std::move(high));
    figure.chart = json::parse(R"json({
        "width": 480, "height": 300,
        "layer": [
            {"transform": [{"filter": "datum.flux_10 > 0"}],
             "mark": {"type": "area", "opacity": 0.15},
             "encoding": {"y": {"field": "flux_10"}, "y2": {"field": "flux_90"}}},
            {"transform": [{"filter": "datum.flux_over_mean > 0"}],
             "mark": {"type": "line", "point": {"size": 18, "filled": true}},
             "encoding": {"y": {"field": "flux_over_mean"}, "tooltip": [
                {"field": "state", "title": "state"}, {"field": "diameter", "title": "d [mm]", "format": ".3g"},
                {"field": "flux_over_mean", "title": "median flux/mean", "format": ".3g"},
                {"field": "flux_10", "title": "10 % quantile", "format": ".3g"},
                {"field": "flux_90", "title": "90 % quantile", "format": ".3g"}]}}
        ]
    })json");
    const auto [least, most] = std::ranges::minmax(figure.table.numbers("diameter"));
    json& size = figure.chart["encoding"]["x"] = size_axis(least / 1.05, 1.05 * most, false);
    size["field"] = "diameter";
    size["title"] = "diameter of the throat's constriction d [mm]";
    const json axis = {{"labelExpr", power_of_ten_labels()}, {"tickCount", 6}};
    for (json& layer : figure.chart["layer"]) {
        layer["encoding"]["y"].update(
            {{"type", "quantitative"},
             {"title", "flux over the mean flux q/q̄ [-]"},
             {"scale", {{"type", "log"}}},
             {"axis", axis}}
        );
    }
    color_states(figure.chart["layer"][1]["encoding"], names_of(states));
    figure.chart["layer"][0]["encoding"]["color"] = figure.chart["layer"][1]["encoding"]["color"];
    return figure;
}

std::optional<Figure> flux_shares(const std::vector<FluxState>& states) {
    std::vector<std::string> state;
    std::vector<double> share, ratio, carried, half;
    std::string claim;
    for (const FluxState& each : states) {
        const ThroatFlux& flux = each.flux;
        if (flux.carried.empty()) {
            continue;
        }
        const std::size_t last = flux.carried.size() - 1; // shares 0, 1/last, ... 1
        for (std::size_t k = 0; k < flux.carried.size(); ++k) {
            state.push_back(each.name);
            share.push_back(100.0 * static_cast<double>(k) / static_cast<double>(last));
            ratio.push_back(flux.quantile[k]);
            carried.push_back(100 * flux.carried[k]);
        }
        half.push_back(100 * flux.half_carried_by);
        claim += fmt::format(
            "{}{}: half of the flow goes through {} % of the {} throats, {} % of it through the tenth with most",
            claim.empty() ? "" : "; ", each.name, short_number(100 * flux.half_carried_by), grouped(flux.throats),
            short_number(100 * flux.carried[last / 10])
        );
    }
    if (state.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-flux-shares";
    figure.section = "Water";
    figure.title = "How few throats carry the flow";
    figure.claim = fmt::format("Half of the flow goes through {} % of the throats", range_of(half));
    figure.caption = as_sentence(claim) + ". Flow: the sum of the sizes of all fluxes; thin line: all throats alike.";
    figure.table.add("state", std::move(state));
    figure.table.add("share_of_throats", "%", std::move(share));
    figure.table.add("flux_over_mean", "-", std::move(ratio));
    figure.table.add("share_of_flow", "%", std::move(carried));
    figure.chart = json::parse(R"json({
        "vconcat": [
            {"width": 480, "height": 190,
             "layer": [
                {"mark": {"type": "rule", "color": "#808080", "strokeWidth": 1},
                 "encoding": {"x": {"datum": 0}, "x2": {"datum": 100}, "y": {"datum": 0}, "y2": {"datum": 100}}},
                {"mark": {"type": "line"},
                 "encoding": {
                    "x": {"field": "share_of_throats", "type": "quantitative", "scale": {"domain": [0, 100]}, "axis": {"grid": true},
                          "title": "share of the throats, those with most flux first [%]"},
                    "y": {"field": "share_of_flow", "type": "quantitative", "scale": {"domain": [0, 100]}, "axis": {"grid": true},
                          "title": "share of the flow [%]"},
                    "order": {"field": "share_of_throats"},
                    "tooltip": [{"field": "state", "title": "state"},
                        {"field": "share_of_throats", "title": "of the throats [%]"},
                        {"field": "share_of_flow", "title": "of the flow [%]", "format": ".3g"}]}}
             ]},
            {"width": 480, "height": 190,
             "transform": [{"filter": "datum.flux_over_mean > 1e-6"}],
             "mark": {"type": "line"},
             "encoding": {
                "x": {"field": "flux_over_mean", "type": "quantitative", "scale": {"type": "log", "nice": false},
                      "title": "flux over the mean flux q/q̄ [-]"},
                "y": {"field": "share_of_throats", "type": "quantitative", "scale": {"domain": [0, 100]},
                      "title": "throats with less [%]"},
                "order": {"field": "share_of_throats"},
                "tooltip": [{"field": "state", "title": "state"},
                    {"field": "flux_over_mean", "title": "q/q̄", "format": ".3g"},
                    {"field": "share_of_throats", "title": "throats with less [%]"}]}}
        ],
        "spacing": 16
    })json");
    json& panels = figure.chart["vconcat"];
    panels[1]["encoding"]["x"]["axis"] = {{"labelExpr", power_of_ten_labels()}, {"tickCount", 6}};
    color_states(panels[0]["layer"][1]["encoding"], names_of(states));
    color_states(panels[1]["encoding"], names_of(states));
    return figure;
}

} // namespace suffuse::figures
