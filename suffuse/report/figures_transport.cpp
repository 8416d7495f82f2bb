// Ours: how far the detached fines of each pass got with the water, where they travel.
#include "suffuse/erosion/transport.hpp"
#include "suffuse/report/figures.hpp"
#include "suffuse/report/passes.hpp"
#include "suffuse/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace suffuse::report {
namespace {

using erosion::ErosionResult;
using erosion::Fate;
using erosion::PassResult;
using erosion::Transport;
using nlohmann::json;

constexpr std::size_t most_curves = 6;
constexpr int points = 100; ///< of a curve

/// Detached mass that got farther than `travel` along the flow, of all that was detached [-].
double share_beyond(const Transport& transport, double travel) {
    double beyond = 0;
    for (std::size_t k = 0; k < transport.size(); ++k) {
        beyond += transport.travel[k] > travel || transport.fate[k] == Fate::Left ? transport.mass[k] : 0;
    }
    return beyond / std::accumulate(transport.mass.begin(), transport.mass.end(), 0.0);
}

} // namespace

std::optional<Figure> transport_by_pass(const ErosionResult& erosion) {
    SomePasses that_travelled;
    for (const PassResult& pass : erosion.passes) {
        if (pass.transport.size() > 0) {
            that_travelled.push_back(&pass);
        }
    }
    if (that_travelled.empty()) {
        return std::nullopt;
    }
    std::vector<std::string> name;
    std::vector<double> travel, share;
    for (const PassResult* pass : that_travelled) {
        for (int k = 0; k <= points; ++k) {
            const double x = pass->transport.distance * k / points;
            name.push_back(pass_name(pass->pass));
            travel.push_back(1e3 * x);
            share.push_back(100 * share_beyond(pass->transport, x));
        }
    }
    const SomePasses few = few_of(that_travelled, most_curves);
    std::string reached, coefficients;
    for (const PassResult* pass : few) {
        reached += fmt::format(
            "{}{} % of what pass {} detached", reached.empty() ? "" : ", ",
            short_number(100 * share_beyond(pass->transport, pass->transport.distance), 2), pass->pass
        );
        const double held = erosion::filter_coefficient(pass->transport).value_or(0);
        coefficients += fmt::format("{}{}", coefficients.empty() ? "" : ", ", short_number(held / 1e3, 2));
    }
    Figure figure;
    figure.id = "own-transport";
    figure.section = "Erosion";
    figure.title = "How far the detached fines get with the water";
    figure.caption = fmt::format(
        "{} mm along the flow, where a grain counts as having left, are reached by {}{}; filter coefficient {} per mm. "
        "The others meet a constriction no wider than themselves, and stand in the way of the next.",
        short_number(1e3 * few.front()->transport.distance), reached, told_of(few, that_travelled.size()), coefficients
    );
    figure.table.add("pass", std::move(name));
    figure.table.add("travel", "mm", std::move(travel));
    figure.table.add("share_farther", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 560, "height": 280,
        "mark": {"type": "line", "strokeWidth": 2.2},
        "encoding": {
            "x": {"field": "travel", "type": "quantitative", "title": "travel along the flow [mm]"},
            "y": {"field": "share_farther", "type": "quantitative", "title": "detached mass that gets farther [%]",
                  "scale": {"domain": [0, 100]}},
            "color": {"field": "pass", "type": "nominal", "title": null},
            "tooltip": [{"field": "pass", "title": "pass"}, {"field": "travel", "title": "travel [mm]", "format": ".3g"},
                        {"field": "share_farther", "title": "gets farther [%]", "format": ".3g"}]
        }
    })json");
    const std::vector<std::string> order = pass_names(few);
    figure.chart["transform"] = {{{"filter", {{"field", "pass"}, {"oneOf", order}}}}};
    figure.chart["encoding"]["color"]["scale"] = {{"domain", order}, {"range", color::sequence()}};
    return figure;
}

} // namespace suffuse::report
