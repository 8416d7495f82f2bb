// Ours: what erosion did to the sample's response, to water and to load.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::figures {

namespace {

using erosion::ErosionResult;
using erosion::PassResult;
using nlohmann::json;

/// What is written next to each state: nothing where the next one lies on it, and names both; the first and the last
/// state alone where there are many. A permeability that has changed sets two states apart, too.
std::vector<std::string> labels(
    const std::vector<std::string>& state, const std::vector<double>& eroded, const std::vector<double>& permeability
) {
    constexpr std::size_t many = 8;
    std::vector<std::string> shown = state;
    if (state.size() > many) {
        std::fill(shown.begin() + 1, shown.end() - 1, "");
        return shown;
    }
    const double highest = *std::max_element(permeability.begin(), permeability.end());
    for (std::size_t k = 0; k + 1 < state.size(); ++k) {
        const double change = std::abs(permeability[k + 1] - permeability[k]);
        if (eroded[k + 1] - eroded[k] < 0.04 * eroded.back() && change < 0.06 * highest) {
            shown[k + 1] = shown[k] + (k == 0 ? ", after " : " and ") + study::pass_name(static_cast<int>(k) + 1);
            shown[k].clear();
        }
    }
    return shown;
}

/// "rises by 0.6 %", "is 3.5 times its initial value".
std::string change_in_words(double times) {
    if (std::abs(times - 1) < erosion::least_permeability_change) {
        return "does not change";
    }
    return times < 1     ? fmt::format("falls to {} % of its initial value", short_number(100 * times, 2))
           : times < 1.1 ? fmt::format("rises by {} %", short_number(100 * (times - 1), 2))
                         : fmt::format("is {} times its initial value", short_number(times, 2));
}

/// By which solver the states were measured: two do not compare as well as one does.
std::string solvers_in_words(const std::vector<flow::Solver>& solvers) {
    const auto resolved = std::ranges::count(solvers, flow::Solver::Resolved);
    return resolved == 0                     ? "By the pore network."
           : resolved == std::ssize(solvers) ? "By the flow between the grains themselves, on a grid."
                                             : fmt::format(
                                                   "{} of {} states are by the flow between the grains themselves, on "
                                                   "a grid, the others by the pore network.",
                                                   resolved, solvers.size()
                                               );
}

} // namespace

std::optional<Figure> permeability_by_pass(const ErosionResult& erosion) {
    std::vector<std::string> state;
    std::vector<double> eroded, permeability;
    std::vector<flow::Solver> solvers;
    double mass = 0;
    for (const PassResult& pass : erosion.passes) {
        if (state.empty() && pass.permeability_before > 0) {
            state.emplace_back("before erosion");
            eroded.push_back(mass);
            permeability.push_back(pass.permeability_before);
            solvers.push_back(pass.probe.flow.solver);
        }
        mass += pass.eroded_mass_percent_of_initial;
        if (pass.permeability_after > 0) {
            state.push_back("after " + study::pass_name(pass.pass));
            eroded.push_back(mass);
            permeability.push_back(pass.permeability_after);
            solvers.push_back(pass.flow_after.solver);
        }
    }
    if (state.size() < 2) {
        return std::nullopt;
    }
    Figure figure;
    figure.id = "own-permeability";
    figure.section = "Water";
    figure.title = "Permeability before and after erosion";
    const double times = permeability.back() / permeability.front();
    figure.claim = "The permeability " + change_in_words(times);
    figure.caption = fmt::format(
        "{}: the permeability along the flow goes from {} to {} m². {}",
        eroded.back() > 0 ? fmt::format("{} % of the mass left", short_number(eroded.back())) : "No grain left",
        short_number(permeability.front()), short_number(permeability.back()), solvers_in_words(solvers)
    );
    const double highest = *std::max_element(permeability.begin(), permeability.end());
    const int decade = static_cast<int>(std::floor(std::log10(highest)));
    const double unit = std::pow(10.0, decade);
    figure.table.add("label", labels(state, eroded, permeability));
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
            {"transform": [{"filter": "datum.label && !datum.low"}],
             "mark": {"type": "text", "align": "left", "dx": 8, "dy": 14, "color": "#333333"},
             "encoding": {"text": {"field": "label", "type": "nominal"}}},
            {"transform": [{"filter": "datum.label && datum.low"}],
             "mark": {"type": "text", "align": "left", "dx": 14, "dy": 2, "color": "#333333"},
             "encoding": {"text": {"field": "label", "type": "nominal"}}}
        ]
    })json");
    // Below a point that lies on the axis its label would cross the axis' numbers.
    figure.chart["transform"] = {
        {{"calculate", fmt::format("datum.permeability / {}", unit)}, {"as", "drawn"}},
        {{"calculate", fmt::format("datum.permeability < {}", 0.08 * highest)}, {"as", "low"}}};
    figure.chart["encoding"]["y"]["title"] = "permeability k [" + power_of_ten(decade) + " m²]";
    figure.chart["encoding"]["y"]["scale"] = {{"domain", {0, 1.1 * highest / unit}}};
    figure.chart["encoding"]["x"]["scale"] = {{"domain", {0, 1.15 * figure.table.numbers("eroded_mass").back()}}};
    return figure;
}

} // namespace suffuse::figures
