// Ours: what erosion did to the sample's response, to water and to load.
#include "suffuse/report/figures.hpp"
#include "suffuse/report/passes.hpp"
#include "suffuse/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::report {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using nlohmann::json;

} // namespace

std::optional<Figure> permeability_by_pass(const ErosionResult& erosion) {
    std::vector<std::string> state;
    std::vector<double> eroded, permeability;
    double mass = 0;
    for (const PassResult& pass : erosion.passes) {
        if (state.empty() && pass.permeability_before > 0) {
            state.emplace_back("before erosion");
            eroded.push_back(mass);
            permeability.push_back(pass.permeability_before);
        }
        mass += pass.eroded_mass_percent_of_initial;
        if (pass.permeability_after > 0) {
            state.push_back("after " + pass_name(pass.pass));
            eroded.push_back(mass);
            permeability.push_back(pass.permeability_after);
        }
    }
    if (state.size() < 2) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-permeability";
    figure.section = "Water";
    figure.title = "Permeability before and after erosion";
    figure.caption = fmt::format(
        "The loss of {} % of the mass changes the permeability along the flow from {} to {} m², {} times.",
        short_number(eroded.back()), short_number(permeability.front()), short_number(permeability.back()),
        short_number(permeability.back() / permeability.front())
    );
    const double highest = *std::max_element(permeability.begin(), permeability.end());
    const int decade = static_cast<int>(std::floor(std::log10(highest)));
    const double unit = std::pow(10.0, decade);
    figure.table.add("state", std::move(state));
    figure.table.add("eroded_mass", "%", std::move(eroded));
    figure.table.add("permeability", "m2", std::move(permeability));
    figure.chart = json::parse(R"json({
        "width": 360, "height": 240,
        "encoding": {
            "x": {"field": "eroded_mass", "type": "quantitative", "title": "eroded mass, of the initial mass [%]"},
            "y": {"field": "drawn", "type": "quantitative"}
        },
        "layer": [
            {"mark": {"type": "line", "color": "#3b82b8", "point": {"size": 60, "filled": true, "color": "#3b82b8"}},
             "encoding": {"tooltip": [{"field": "state", "title": "state"},
                {"field": "permeability", "title": "k [m²]", "format": ".4g"},
                {"field": "eroded_mass", "title": "eroded mass [%]", "format": ".4g"}]}},
            {"mark": {"type": "text", "align": "left", "dx": 8, "dy": 14, "color": "#333333"},
             "encoding": {"text": {"field": "state", "type": "nominal"}}}
        ]
    })json");
    figure.chart["transform"] = {{{"calculate", fmt::format("datum.permeability / {}", unit)}, {"as", "drawn"}}};
    figure.chart["encoding"]["y"]["title"] = "permeability k [" + power_of_ten(decade) + " m²]";
    figure.chart["encoding"]["y"]["scale"] = {{"domain", {0, 1.1 * highest / unit}}};
    figure.chart["encoding"]["x"]["scale"] = {{"domain", {0, 1.15 * figure.table.numbers("eroded_mass").back()}}};
    return figure;
}

std::optional<Figure> triaxial_response(const std::vector<ResponseCurve>& tests) {
    std::vector<std::string> name, order;
    std::vector<double> axial, volumetric, deviator, mean, void_ratio;
    std::string claim;
    for (const ResponseCurve& test : tests) {
        if (test.rows.empty()) {
            continue;
        }
        order.push_back(test.name);
        const auto peak = std::max_element(
            test.rows.begin(), test.rows.end(),
            [](const StressStrainRow& a, const StressStrainRow& b) { return a.deviator_stress < b.deviator_stress; }
        );
        claim += fmt::format(
            "{}{}: highest q {} kPa at ε₁ = {} %", claim.empty() ? "" : "; ", test.name,
            short_number(peak->deviator_stress / 1e3), short_number(100 * peak->axial_strain)
        );
        for (const StressStrainRow& row : test.rows) {
            name.push_back(test.name);
            axial.push_back(100 * row.axial_strain);
            deviator.push_back(row.deviator_stress / 1e3);
            mean.push_back(row.mean_stress / 1e3);
            volumetric.push_back(100 * row.volumetric_strain);
            void_ratio.push_back(row.void_ratio);
        }
    }
    if (order.empty()) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-triaxial";
    figure.section = "Tests";
    figure.title = "Drained triaxial compression";
    figure.caption = as_sentence(claim) + ". Contraction positive.";
    figure.table.add("test", std::move(name));
    figure.table.add("axial_strain", "%", std::move(axial));
    figure.table.add("deviator_stress", "kPa", std::move(deviator));
    figure.table.add("mean_stress", "kPa", std::move(mean));
    figure.table.add("volumetric_strain", "%", std::move(volumetric));
    figure.table.add("void_ratio", "-", std::move(void_ratio));
    figure.chart = json::parse(R"json({
        "vconcat": [
            {"width": 560, "height": 240, "mark": {"type": "line"}, "encoding": {
                "x": {"field": "axial_strain", "type": "quantitative", "axis": {"title": null, "labels": false, "ticks": false, "tickCount": 8}},
                "y": {"field": "deviator_stress", "type": "quantitative", "title": "deviator stress q = σ₁ − σ₃ [kPa]"}}},
            {"width": 560, "height": 160, "mark": {"type": "line"}, "encoding": {
                "x": {"field": "axial_strain", "type": "quantitative", "title": "axial strain ε₁ [%]",
                      "axis": {"tickCount": 8}},
                "y": {"field": "volumetric_strain", "type": "quantitative", "title": "volumetric strain εᵥ [%]"}}}
        ],
        "spacing": 8,
        "resolve": {"scale": {"x": "shared", "color": "shared", "strokeDash": "shared"}}
    })json");
    for (json& panel : figure.chart["vconcat"]) {
        panel["encoding"]["color"] = {
            {"field", "test"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", order}, {"range", color::sequence()}}}};
        panel["encoding"]["strokeDash"] = {
            {"field", "test"},
            {"type", "nominal"},
            {"title", nullptr},
            {"scale", {{"domain", order}, {"range", json::parse("[[1, 0], [6, 3], [2, 2], [8, 2, 2, 2]]")}}}};
        panel["encoding"]["order"] = {{"field", "axial_strain"}};
        panel["encoding"]["tooltip"] = json::parse(R"json([
            {"field": "test", "title": "test"}, {"field": "axial_strain", "title": "ε₁ [%]", "format": ".3g"},
            {"field": "deviator_stress", "title": "q [kPa]", "format": ".4g"},
            {"field": "volumetric_strain", "title": "εᵥ [%]", "format": ".3g"},
            {"field": "void_ratio", "title": "void ratio e", "format": ".4g"}])json");
    }
    return figure;
}

} // namespace suffuse::report
