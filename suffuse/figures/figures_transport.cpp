// Ours: how far the detached fines of each pass got with the water, where they travel.
#include "suffuse/base/words.hpp"
#include "suffuse/figures/figures.hpp"
#include "suffuse/study/passes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::figures {
namespace {

using erosion::ErosionResult;
using erosion::Fate;
using erosion::PassResult;
using erosion::Transport;
using nlohmann::json;

constexpr std::size_t most_curves = 6;
constexpr std::size_t points = 100; ///< of a curve

/// For each of `points` + 1 equal parts of the distance the share of the detached mass that got farther [%].
std::vector<double> shares_beyond(const Transport& transport) {
    std::vector<double> held(points + 2, 0); // mass, by the part in which it was held; the last: it left
    for (std::size_t k = 0; k < transport.size(); ++k) {
        const double part = std::ceil(std::max(transport.travel[k], 0.0) / transport.distance * points);
        held
            [transport.fate[k] == Fate::Left ? points + 1
                                             : std::min<std::size_t>(static_cast<std::size_t>(part), points)] +=
            transport.mass[k];
    }
    const double all = std::accumulate(held.begin(), held.end(), 0.0);
    std::vector<double> share;
    double left = all;
    for (std::size_t part = 0; part <= points; ++part) {
        left -= held[part];
        share.push_back(100 * std::max(left, 0.0) / all);
    }
    return share;
}

} // namespace

std::optional<Figure> transport_by_pass(const ErosionResult& erosion) {
    study::SomePasses that_travelled;
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
        const std::vector<double> beyond = shares_beyond(pass->transport);
        for (std::size_t k = 0; k < beyond.size(); ++k) {
            name.push_back(study::pass_name(pass->pass));
            travel.push_back(1e3 * pass->transport.distance * static_cast<double>(k) / points);
            share.push_back(beyond[k]);
        }
    }
    const study::SomePasses few = study::few_of(that_travelled, most_curves);
    std::vector<std::string> passes, left, coefficients;
    for (const PassResult* pass : few) {
        passes.push_back(fmt::format("{}", pass->pass));
        left.push_back(short_number(shares_beyond(pass->transport).back(), 2));
        coefficients.push_back(short_number(1e-3 * erosion::filter_coefficient(pass->transport).value_or(0), 2));
    }
    Figure figure;
    figure.id = "own-transport";
    figure.section = "Erosion";
    figure.title = "Travel of the detached fines with the water";
    figure.claim = fmt::format("{} % of the detached mass left", fmt::join(left, ", "));
    figure.caption = fmt::format(
        "{} % of the mass detached in {} {}{} left, having come {} mm along the flow since the erosion began; filter "
        "coefficient {} per mm. The others were held by a throat no wider than themselves and lodge there if there is "
        "room.",
        fmt::join(left, ", "), few.size() == 1 ? "pass" : "passes", fmt::join(passes, ", "),
        study::part_of_passes(few, that_travelled.size()), short_number(1e3 * few.front()->transport.distance),
        fmt::join(coefficients, ", ")
    );
    figure.table.add("pass", std::move(name));
    figure.table.add("travel", "mm", std::move(travel));
    figure.table.add("share_farther", "%", std::move(share));
    figure.chart = json::parse(R"json({
        "width": 560, "height": 280,
        "mark": {"type": "line", "strokeWidth": 2.2},
        "encoding": {
            "x": {"field": "travel", "type": "quantitative", "title": "travel along the flow in the pass [mm]"},
            "y": {"field": "share_farther", "type": "quantitative", "title": "detached mass that gets farther [%]",
                  "scale": {"domain": [0, 100]}},
            "color": {"field": "pass", "type": "nominal", "title": null},
            "tooltip": [{"field": "pass", "title": "pass"}, {"field": "travel", "title": "travel [mm]", "format": ".3g"},
                        {"field": "share_farther", "title": "gets farther [%]", "format": ".3g"}]
        }
    })json");
    const std::vector<std::string> order = study::pass_names(few);
    figure.chart["transform"] = {{{"filter", {{"field", "pass"}, {"oneOf", order}}}}};
    figure.chart["encoding"]["color"]["scale"] = {{"domain", order}, {"range", color::sequence()}};
    return figure;
}

} // namespace suffuse::figures
